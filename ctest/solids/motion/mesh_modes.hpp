#pragma once
// The modes of a laboratory's block, by dense matrices.

#include <Eigen/Eigenvalues>
#include <cmath>
#include <span>
#include <vector>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"
#include "laboratory.hpp"

namespace idiophone::motion {

struct Modes {
  Eigen::VectorXd frequencies;  ///< rad/s, ascending
  Eigen::MatrixXd shapes;       ///< [3 x nodes] each, of modal mass 1 kg
};

/// Modes of the undeformed, undamped mesh with lumped masses.
/// @param springs  [nodes] of supports, N/m; empty for none
inline Modes modes(const Laboratory& lab, std::span<const double> mass, std::span<const double> springs = {}) {
  const auto size = static_cast<Eigen::Index>(3 * lab.mesh.nodes.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  const auto width = static_cast<std::size_t>(element::node_count(lab.mesh.element));
  for (Index e = 0; e < lab.mesh.element_count(); ++e) {
    const auto nodes = lab.mesh.element_nodes(e);
    std::vector<Vector3> reference;
    for (const Index node : nodes) {
      reference.push_back(lab.mesh.nodes[node]);
    }
    const Eigen::MatrixXd k = solid::tangent_stiffness(lab.mesh.element, solid::elasticity(lab.scene.materials[0]),
                                                       reference, std::vector<Vector3>(width, Vector3::Zero()));
    for (std::size_t a = 0; a < width; ++a) {
      for (std::size_t b = 0; b < width; ++b) {
        stiffness.block<3, 3>(Eigen::Index{3} * nodes[a], Eigen::Index{3} * nodes[b]) +=
            k.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
      }
    }
  }
  Eigen::VectorXd root(size);
  for (Eigen::Index c = 0; c < size; ++c) {
    root[c] = 1 / std::sqrt(mass[c / 3]);
    stiffness(c, c) += springs.empty() ? 0.0 : springs[c / 3];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(root.asDiagonal() * stiffness * root.asDiagonal());
  return {solver.eigenvalues().cwiseMax(0.0).cwiseSqrt(), root.asDiagonal() * solver.eigenvectors()};
}

}  // namespace idiophone::motion
