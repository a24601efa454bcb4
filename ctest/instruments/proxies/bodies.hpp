#pragma once
// Small bodies for the tests of proxies.

#include <Eigen/Eigenvalues>
#include <memory>
#include <random>
#include <utility>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

inline constexpr Material rubber{.young = 1e6, .density = 1000.0, .damping = {.mass = 5.0, .stiffness = 1e-5}};

/// A box from the origin to `size` (m), whose inner nodes are moved at random by a share of the cells' size.
inline TetrahedralMesh box(const Vector3& size, const std::array<int, 3>& cells, double disorder = 0.0) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-disorder, disorder);
  return grid_mesh(cells, [&](const Vector3& at) {
    Vector3 moved = at;
    for (Index axis = 0; axis < 3; ++axis) {
      if (at[axis] > 0.0 && at[axis] < 1.0) {
        moved[axis] += uniform(random) / cells[axis];
      }
    }
    return Vector3(moved.cwiseProduct(size));
  });
}

inline std::shared_ptr<const Lattice> rubber_cube(int cells, double size = 0.1,
                                                  const Damping& damping = rubber.damping) {
  return std::make_shared<Lattice>(box(Vector3::Constant(size), {cells, cells, cells}, 0.2),
                                   Material{.young = rubber.young, .density = rubber.density, .damping = damping});
}

/// A regular tetrahedron with corners at the distance 1 m from the centre, four equal masses.
inline TetrahedralMesh regular_tetrahedron() {
  TetrahedralMesh mesh;
  mesh.nodes = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (Vector3& node : mesh.nodes) {
    node.normalize();
  }
  mesh.tetrahedra = {{0, 1, 2, 3}};
  mesh.surface = exterior_triangles(mesh.nodes, mesh.tetrahedra);
  return mesh;
}

/// Stiffness of all springs about the body at rest, with their tension, [3 masses x 3 masses] N/m.
inline Eigen::MatrixXd stiffness_of(const Lattice& lattice) {
  const Index size = 3 * static_cast<Index>(lattice.masses().size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const Spring& spring : lattice.springs()) {
    const Vector3 way = lattice.mesh().nodes[spring.b] - lattice.mesh().nodes[spring.a], n = way.normalized();
    const double force = spring.stiffness * (way.norm() - spring.natural);
    const Eigen::Matrix3d along = n * n.transpose();
    const Eigen::Matrix3d block = spring.stiffness * along + force / way.norm() * (Eigen::Matrix3d::Identity() - along);
    for (const auto& [i, j] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
      sum.block<3, 3>(3 * i, 3 * i) += block;
      sum.block<3, 3>(3 * i, 3 * j) -= block;
    }
  }
  return sum;
}

using Eigensystem = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>;

/// All modes of a free body: squares of angular frequencies, ascending, and shapes of unit modal mass.
inline Eigensystem modes_of(const Lattice& lattice) {
  Eigen::VectorXd masses(3 * std::ssize(lattice.masses()));
  for (Eigen::Index i = 0; i < masses.size(); ++i) {
    masses[i] = lattice.masses()[static_cast<std::size_t>(i / 3)];
  }
  const Eigen::MatrixXd mass = masses.asDiagonal();
  return Eigensystem(stiffness_of(lattice), mass);
}

}  // namespace idiophone::proxies
