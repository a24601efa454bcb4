#include "equilibrium.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "free_masses.hpp"

namespace idiophone::proxies {

namespace {

constexpr int most_iterations = 200;
constexpr double largest_rest = 1e-10;   // of the forces, over the largest pull of a spring in the mesh
constexpr double regularization = 1e-9;  // over the largest stiffness: a free body moves without force

/// The elastic energy as a function of the places of the masses that are not pinned.
class Energy {
 public:
  Energy(std::span<const Spring> springs, const std::vector<bool>& pinned) : springs_(springs), masses_(pinned) {}

  [[nodiscard]] std::vector<Vector3> moved(const std::vector<Vector3>& nodes, const Eigen::VectorXd& step) const {
    std::vector<Vector3> result = nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (masses_.is_free(i)) {
        result[i] += step.segment<3>(masses_.first(i));
      }
    }
    return result;
  }

  /// J
  [[nodiscard]] double value(const std::vector<Vector3>& nodes) const {
    double sum = 0.0;
    for (const Spring& spring : springs_) {
      sum += 0.5 * spring.stiffness * std::pow((nodes[spring.b] - nodes[spring.a]).norm() - spring.natural, 2);
    }
    return sum;
  }

  /// N
  [[nodiscard]] Eigen::VectorXd forces(const std::vector<Vector3>& nodes) const {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(masses_.unknowns());
    for (const Spring& spring : springs_) {
      const Vector3 way = nodes[spring.b] - nodes[spring.a];
      const Vector3 pull = spring.stiffness * (1.0 - spring.natural / way.norm()) * way;
      add(forces, spring.a, pull);
      add(forces, spring.b, -pull);
    }
    return forces;
  }

  /// Second derivatives, N/m. @param with_pressed  whether what springs that are pressed take away across them counts
  [[nodiscard]] Eigen::SparseMatrix<double> stiffness(const std::vector<Vector3>& nodes, bool with_pressed) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Spring& spring : springs_) {
      const Vector3 way = nodes[spring.b] - nodes[spring.a], n = way.normalized();
      const double tension_over_length = spring.stiffness * (1.0 - spring.natural / way.norm());
      const double across = with_pressed ? tension_over_length : std::max(tension_over_length, 0.0);
      const Eigen::Matrix3d block =
          spring.stiffness * n * n.transpose() + across * (Eigen::Matrix3d::Identity() - n * n.transpose());
      masses_.add_spring(entries, spring, block);
    }
    Eigen::SparseMatrix<double> matrix(masses_.unknowns(), masses_.unknowns());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const double shift = regularization * matrix.diagonal().maxCoeff();
    matrix.diagonal().array() += shift;
    return matrix;
  }

 private:
  void add(Eigen::VectorXd& forces, Index mass, const Vector3& force) const {
    if (masses_.is_free(mass)) {
      forces.segment<3>(masses_.first(mass)) += force;
    }
  }
  std::span<const Spring> springs_;
  FreeMasses masses_;
};

using Factors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

bool is_positive(const Factors& factors) {
  return factors.info() == Eigen::Success && factors.vectorD().minCoeff() > 0.0;
}

/// Towards a minimum, also from where the energy is not convex.
Eigen::VectorXd newton_step(const Energy& energy, const std::vector<Vector3>& nodes, const Eigen::VectorXd& forces) {
  Factors factors(energy.stiffness(nodes, true));
  if (!is_positive(factors)) {
    factors.compute(energy.stiffness(nodes, false));
  }
  return factors.solve(forces);
}

/// Of a step that is taken. Close to the minimum, energies differ by less than their rounding, but forces do not.
double share_of(const Eigen::VectorXd& step, const Energy& energy, const std::vector<Vector3>& nodes, double force) {
  constexpr int most_halvings = 20;
  const double before = energy.value(nodes);
  double share = 1.0;
  for (int halving = 0; halving < most_halvings; ++halving) {
    const std::vector<Vector3> next = energy.moved(nodes, share * step);
    if (energy.value(next) < before || energy.forces(next).norm() < 0.5 * force) {
      break;
    }
    share *= 0.5;
  }
  return share;
}

double largest_pull(const std::vector<Vector3>& nodes, std::span<const Spring> springs) {
  double largest = 0.0;
  for (const Spring& spring : springs) {
    const double length = (nodes[spring.b] - nodes[spring.a]).norm();
    largest = std::max(largest, spring.stiffness * std::abs(length - spring.natural));
  }
  return largest;
}

}  // namespace

std::vector<Vector3> equilibrium(const std::vector<Vector3>& nodes, std::span<const Spring> springs,
                                 const std::vector<bool>& pinned) {
  const Energy energy(springs, pinned);
  const double enough = largest_rest * largest_pull(nodes, springs);
  std::vector<Vector3> present = nodes;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::VectorXd forces = energy.forces(present);
    if (forces.size() == 0 || forces.cwiseAbs().maxCoeff() <= enough) {
      if (forces.size() > 0 && !is_positive(Factors(energy.stiffness(present, true)))) {
        break;  // it would buckle
      }
      return present;
    }
    const Eigen::VectorXd step = newton_step(energy, present, forces);
    present = energy.moved(present, share_of(step, energy, present, forces.norm()) * step);
  }
  throw std::invalid_argument(
      "the springs have no stable equilibrium with these natural lengths; they must be closer to the lengths in the "
      "mesh");
}

}  // namespace idiophone::proxies
