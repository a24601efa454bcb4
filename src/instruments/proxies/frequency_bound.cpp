#include "frequency_bound.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

namespace idiophone::proxies {

std::vector<double> frequency_bounds(std::span<const Vector3> nodes, std::span<const Spring> springs,
                                     std::span<const double> masses, const std::vector<bool>& pinned) {
  std::vector<Eigen::Matrix3d> stiffness(masses.size(), Eigen::Matrix3d::Zero());
  for (const Spring& spring : springs) {
    const Vector3 way = nodes[spring.b] - nodes[spring.a], direction = way.normalized();
    const double across = std::max(spring.tension / way.norm(), 0.0);
    const Eigen::Matrix3d of_spring =
        (spring.stiffness - across) * direction * direction.transpose() + across * Eigen::Matrix3d::Identity();
    stiffness[spring.a] += of_spring;
    stiffness[spring.b] += of_spring;
  }
  std::vector<double> bounds(masses.size());
  for (std::size_t i = 0; i < masses.size(); ++i) {
    if (!pinned[i]) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(stiffness[i], Eigen::EigenvaluesOnly);
      bounds[i] = 2.0 * solver.eigenvalues()[2] / masses[i];
    }
  }
  return bounds;
}

}  // namespace idiophone::proxies
