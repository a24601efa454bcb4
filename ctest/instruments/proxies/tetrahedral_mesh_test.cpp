#include "idiophone/instruments/proxies/tetrahedral_mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bodies.hpp"

namespace idiophone::proxies {
namespace {

/// Volume inside a closed surface, by the divergence theorem.
double volume_inside(const TetrahedralMesh& mesh) {
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.surface) {
    volume += mesh.nodes[a].dot(mesh.nodes[b].cross(mesh.nodes[c])) / 6.0;
  }
  return volume;
}

TEST(TetrahedralMesh, GridFillsABoxWithOutwardTriangles) {
  const TetrahedralMesh mesh = box({0.3, 0.2, 0.1}, {3, 2, 4}, 0.2);
  EXPECT_EQ(mesh.nodes.size(), 4 * 3 * 5);
  EXPECT_EQ(mesh.tetrahedra.size(), 6 * 3 * 2 * 4);
  EXPECT_EQ(mesh.surface.size(), 4 * (3 * 2 + 2 * 4 + 4 * 3));
  EXPECT_NEAR(volume_inside(mesh), 0.006, 1e-15);
}

TEST(TetrahedralMesh, ClosedSeamMakesARing) {
  constexpr int around = 60;
  const TetrahedralMesh ring = grid_mesh(
      {around, 1, 2},
      [](const Vector3& at) {
        const double angle = 2.0 * std::numbers::pi * at[0], radius = 2.0 - at[1];
        return Vector3(radius * std::cos(angle), radius * std::sin(angle), at[2]);
      },
      Seam::closed);
  EXPECT_EQ(ring.nodes.size(), around * 2 * 3);
  EXPECT_EQ(ring.surface.size(), 2 * around * (2 + 2 + 1 + 1));  // no triangle at the seam
  EXPECT_NEAR(std::abs(volume_inside(ring)), 3.0 * std::numbers::pi, 0.02);
}

TEST(TetrahedralMesh, GridNeedsCells) {
  const auto stay = [](const Vector3& at) { return at; };
  EXPECT_THROW((void)grid_mesh({0, 1, 1}, stay), std::invalid_argument);
  EXPECT_THROW((void)grid_mesh({2, 1, 1}, stay, Seam::closed), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::proxies
