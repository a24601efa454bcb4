#pragma once
// A block of wood under a uniform strain.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numeric>
#include <vector>

#include "block_mesh.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::solid {

using Eigen::Matrix3d;

/// Sitka spruce.
inline scene::Material spruce() {
  scene::Material material{"spruce", 11.9e9, 0.0, 450, {0, 1e-6}, {}};
  material.orthotropy = {{11.9e9, 0.93e9, 0.51e9}, {0.372, 0.435, 0.467}, {0.76e9, 0.036e9, 0.73e9}};
  return material;
}

inline Matrix3d some_turn() {
  return Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();
}

struct StrainedBlock {
  explicit StrainedBlock(element::Type type)
      : mesh(support::block_mesh(type, {0.3, 0.2, 0.1}, {2, 2, 1})),
        part(support::whole_part(mesh)),
        state(mesh.nodes.size()) {}

  [[nodiscard]] Solid solid(const scene::Material& material, const Matrix3d& axes) const {
    return {part.bodies[0], part.reference, material, axes};
  }

  /// Displacement u = H X and velocity v = H' X.
  void move(const Matrix3d& gradient, const Matrix3d& rate = Matrix3d::Zero()) {
    for (std::size_t node = 0; node < state.size(); ++node) {
      Eigen::Map<Vector3>(state[node].displacement) = gradient * mesh.nodes[node];
      Eigen::Map<Vector3>(state[node].velocity) = rate * mesh.nodes[node];
    }
  }

  /// Uniform first Piola-Kirchhoff stress, Pa: the sum of -f X^T over the volume.
  [[nodiscard]] Matrix3d stress(const Solid& body) const {
    std::vector<NodeForce> force(state.size());
    body.add_internal_force(state, force);
    Matrix3d sum = Matrix3d::Zero();
    for (std::size_t node = 0; node < state.size(); ++node) {
      sum -= Eigen::Map<const Vector3>(force[node].component) * mesh.nodes[node].transpose();
    }
    return sum / volume;
  }
  [[nodiscard]] double energy(const Solid& body) const {
    std::vector<double> each(body.element_count());
    body.elastic_energy(state, each);
    return std::accumulate(each.begin(), each.end(), 0.0);
  }

  static constexpr double volume = 0.3 * 0.2 * 0.1;
  static constexpr double strain = 1e-7;  // so small that the nonlinear part is 1e-7 of the whole
  mesh::Mesh mesh;
  mesh::Part part;
  std::vector<NodeState> state;
};

}  // namespace idiophone::solid
