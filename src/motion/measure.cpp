#include "idiophone/motion/measure.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace idiophone::motion {

namespace {

constexpr int travel_exponent = 10;  // of two: the length unit in sizes of the body

double power_of_two_below(double value) {
  return std::scalbn(1.0, std::ilogb(value));
}

void add(std::array<ReproducibleSum, 3>& sums, const Vector3& terms) {
  for (std::size_t i = 0; i < 3; ++i) {
    sums[i].add(terms[i]);
  }
}

/// Adds a symmetric matrix: xx, xy, yy, xz, yz, zz.
void add(std::array<ReproducibleSum, 6>& sums, const Eigen::Matrix3d& terms) {
  for (std::size_t entry = 0, column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row <= column; ++row) {
      sums[entry++].add(terms(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
    }
  }
}

/// Adds what one node has, all in BodyUnits and s.
/// @param mass  lumped
/// @param arm   X - C
void add_node(BodySums& sums, double mass, const Vector3& arm, const Vector3& displacement, const Vector3& velocity,
              const Vector3& momentum) {
  const Vector3 weighted = mass * displacement;
  add(sums.displacement, weighted);
  add(sums.momentum, momentum);
  add(sums.angular_momentum, (arm + displacement).cross(momentum));
  for (std::size_t cross = 0, second = 0, column = 0; column < 3; ++column) {
    const auto j = static_cast<Eigen::Index>(column);
    for (Eigen::Index i = 0; i < 3; ++i) {
      sums.cross_moment[cross++].add(weighted[i] * arm[j]);
      if (i <= j) {
        sums.second_moment[second++].add(weighted[i] * displacement[j]);
      }
    }
  }
  sums.kinetic.add(momentum.dot(velocity) / 2);
}

}  // namespace

BodyUnits::BodyUnits(const InitialState& initial_state, std::size_t body)
    : mass(power_of_two_below(initial_state.masses[body])),
      length(
          std::scalbn(power_of_two_below(std::sqrt(initial_state.moments[body].trace() / initial_state.masses[body])),
                      travel_exponent)) {}

std::vector<BodySums> measure(Motion& motion, const mesh::Part& part, const InitialState& initial_state) {
  std::vector<Vector3> velocity;
  motion.evaluate(velocity);
  std::vector<BodySums> bodies(part.bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const mesh::BodyPart& body = part.bodies[b];
    const BodyUnits unit(initial_state, b);
    const solid::Mass& mass = motion.dynamics().mass(b);
    mass.multiply(motion.state(), velocity, [&](Index node, const Vector3& momentum) {
      const Eigen::Map<const Vector3> displacement(motion.state()[node].displacement);
      add_node(bodies[b], mass.lumped(node) / unit.mass,
               (part.reference[node] - initial_state.centres[b]) / unit.length, displacement / unit.length,
               velocity[node], momentum / unit.mass);
    });
    for (const Eigen::Matrix3d& moment : mass.added_second_moments(motion.state())) {
      add(bodies[b].added_moment, moment / (unit.mass * unit.length * unit.length));
    }
    std::vector<double> energy(body.element_ids.size());
    motion.dynamics().solid(b).elastic_energy(motion.state(), energy);
    for (std::size_t element = 0; element < energy.size(); ++element) {
      if (body.owned[element] != 0) {
        bodies[b].elastic.add(energy[element] / unit.mass);
      }
    }
  }
  return bodies;
}

}  // namespace idiophone::motion
