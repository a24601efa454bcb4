#include "damped_mode.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/eigenmodes/material_damping.hpp"
#include "shares_of_strain.hpp"

namespace idiophone::eigenmodes {

namespace {

constexpr double radians = 2 * std::numbers::pi;  // of 1 Hz in 1 s

/// Turns the sign of each shape so that its largest component is positive. Of components that are as large, but for
/// rounding, the one with the lowest global number counts.
void orient(std::vector<double>& shape, const mesh::Part& part, MPI_Comm communicator) {
  double largest = 0.0;
  for (const double value : shape) {
    largest = std::max(largest, std::abs(value));
  }
  largest = parallel::largest(largest, communicator);
  constexpr double as_large = 1 - 1e-3;
  std::int64_t first = std::numeric_limits<std::int64_t>::max();  // twice a component's number, and 1 if it is negative
  for (std::size_t c = 0; c < shape.size(); ++c) {
    if (std::abs(shape[c]) >= as_large * largest) {
      const std::int64_t component = 3 * std::int64_t{part.node_ids[c / 3]} + static_cast<std::int64_t>(c % 3);
      first = std::min(first, 2 * component + (shape[c] < 0 ? 1 : 0));
    }
  }
  const bool negative = parallel::smallest(first, communicator) % 2 == 1;
  for (double& value : shape) {
    value *= negative ? -1.0 : 1.0;
  }
}

/// How fast a motion of this damping ratio dies away, over w: as its envelope below critical damping, and above it as
/// the slower of the two motions without oscillation, zeta - sqrt(zeta^2 - 1).
double decay_factor(double damping_ratio) {
  if (damping_ratio <= 1) {
    return damping_ratio;
  }
  return 1 / (damping_ratio + std::sqrt(damping_ratio * damping_ratio - 1));
}

/// [bodies] of the kinetic energy.
std::vector<double> kinetic_shares(const mesh::Part& part, const motion::Dynamics& dynamics,
                                   std::span<const double> shape, MPI_Comm communicator) {
  std::vector<double> shares(part.bodies.size());
  for (std::size_t b = 0; b < shares.size(); ++b) {
    const std::span<const double> masses = dynamics.model(b).masses();
    for (std::size_t node = 0; node < masses.size(); ++node) {
      shares[b] += masses[node] * Vector3(&shape[3 * (part.bodies[b].owned_begin + node)]).squaredNorm();
    }
  }
  parallel::reduce(shares, MPI_SUM, communicator);
  const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::ranges::for_each(shares, [&](double& share) { share /= all; });
  return shares;
}

/// alpha of a mode, 1/s: the mean of its bodies', each with its share of the kinetic energy.
double mass_damping(const scene::Solids& solids, std::span<const double> kinetic_shares) {
  double alpha = 0.0;
  for (std::size_t b = 0; b < kinetic_shares.size(); ++b) {
    alpha += kinetic_shares[b] * solids.materials[solids.bodies[b].material].damping.of_all_motion();
  }
  return alpha;
}

/// Sets frequency and damping from those of the lossless bodies, w. With unit modal mass their strain is worth
/// W = w^2 - x^T S x - x^T J x, as supports' springs S and joints J strain no material, nor does the geometric
/// stiffness of a prestress. The materials damp as damped() says; the dashpots C and the joints, with their relaxation
/// time tau, add x^T C x + tau x^T J x to 2 zeta w. Each material has its own beta, M and share of W.
/// @param alpha      mass-proportional damping, 1/s
/// @param of_stress  as damped_mode()
void vibrate(Mode& mode, const Eigenpair& pair, double alpha, double of_stress, const Operators& operators,
             const mesh::Part& part, MPI_Comm communicator) {
  std::array<double, 2> sums = {};
  for (std::size_t c = 0; c < pair.vector.size(); ++c) {
    const double square = pair.vector[c] * pair.vector[c];
    sums[0] += operators.support()[c / 3] * square;
    sums[1] += operators.dashpot()[c / 3] * square;
  }
  parallel::reduce(sums, MPI_SUM, communicator);
  const joints::Joints& joints = operators.dynamics().joints();
  const std::vector<double> of_joints = shares_of_joints(joints, part, pair.vector, communicator);
  double in_materials = pair.value - sums[0];
  double damping = alpha;
  for (std::size_t joint = 0; joint < of_joints.size(); ++joint) {
    in_materials -= of_joints[joint];
    damping += joints.all()[joint].damping * of_joints[joint];
  }
  std::vector<MaterialStrain> materials;
  for (const auto& [solid, region, share, relaxing] :
       shares_of_strain(operators.dynamics(), part, pair.vector, std::max(0.0, in_materials), communicator)) {
    materials.push_back({share, relaxing, solid->stiffness_damping(region), solid->relaxation(region)});
  }
  const double square = pair.value + of_stress;
  const DampedVibration vibration = damped(square, damping, materials);
  const double w = vibration.angular_frequency;
  mode.frequency = w / radians;
  mode.lossless_frequency = std::sqrt(square) / radians;
  mode.damping_ratio = (vibration.damping + sums[1]) / (2 * w);
  mode.decay_time = std::log(1000.0) / (decay_factor(mode.damping_ratio) * w);
}

}  // namespace

Mode damped_mode(Eigenpair pair, const scene::Solids& solids, const Operators& operators, const mesh::Part& part,
                 MPI_Comm communicator, double of_stress) {
  Mode mode;
  mode.kinetic_shares = kinetic_shares(part, operators.dynamics(), pair.vector, communicator);
  vibrate(mode, pair, mass_damping(solids, mode.kinetic_shares), of_stress, operators, part, communicator);
  mode.shape = std::move(pair.vector);
  orient(mode.shape, part, communicator);
  return mode;
}

}  // namespace idiophone::eigenmodes
