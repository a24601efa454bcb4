#include "idiophone/air/surface/equivalent_radius.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "vibrating_solid.hpp"

namespace idiophone::surface {
namespace {

/// Mean of a/2 over the triangles that look along z: added mass per area and density of air.
double mean_added_length(const radiation::Solid& solid) {
  const auto corners = solid.corners();
  const auto radii = solid.radii();
  double volume = 0.0, area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3 twice = (corners[i][1] - corners[i][0]).cross(corners[i][2] - corners[i][0]);
    if (twice.normalized().z() > 0.999) {
      area += twice.norm() / 2.0;
      volume += radii[i] / 2.0 * twice.norm() / 2.0;
    }
  }
  return volume / area;
}

/// A cube of edge 1 m; each face in 2 n^2 triangles.
radiation::Solid cube(int n) {
  radiation::Solid solid;
  for (int face = 0; face < 6; ++face) {
    const double side = face < 3 ? 0.5 : -0.5;
    Vector3 outwards = Vector3::Zero(), across = Vector3::Zero();
    outwards[face % 3] = side;
    across[(face + 1) % 3] = 0.5;
    const Vector3 along = 2.0 * outwards.cross(across);
    const auto first = static_cast<Index>(solid.vertices.size());
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        solid.vertices.emplace_back(outwards + (2.0 * i / n - 1.0) * across + (2.0 * j / n - 1.0) * along);
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const Index corner = first + i * (n + 1) + j;
        solid.triangles.push_back({corner, corner + n + 1, corner + n + 2});
        solid.triangles.push_back({corner, corner + n + 2, corner + 1});
      }
    }
  }
  return solid;
}

TEST(EquivalentRadius, IsASpheresOwn) {
  for (const auto& [n, tolerance] : {std::pair(6, 0.06), std::pair(12, 0.02), std::pair(24, 0.006)}) {
    const auto radii = radiation::sphere(0.03, n).radii();
    EXPECT_NEAR(std::ranges::max(radii), 0.03, tolerance * 0.03);
    EXPECT_NEAR(std::ranges::min(radii), 0.03, tolerance * 0.03);
  }
}

TEST(EquivalentRadius, IsNearTheAddedMassOfDiscsAndCubes) {
  // A thin disc: 8/3 a^3 on two faces of pi a^2 (Lamb), 0.5 dB lower. A cube: 0.67 of its volume on two faces.
  EXPECT_NEAR(mean_added_length(radiation::disc(1.0, 16, 0.02)) / (4.0 / (3.0 * std::numbers::pi)), 1.06, 0.02);
  EXPECT_NEAR(mean_added_length(cube(12)) / (0.67 / 2.0), 0.75, 0.02);
}

TEST(EquivalentRadius, DoesNotFeelEdgesAndTheBack) {
  const auto one_sided = radiation::disc(1.0, 8).radii();
  const auto two_sided = radiation::disc(1.0, 8, 1e-3).radii();
  for (std::size_t i = 0; i < one_sided.size(); ++i) {
    EXPECT_NEAR(one_sided[i], two_sided[2 * i], 1e-9);
    EXPECT_NEAR(one_sided[i], two_sided[2 * i + 1], 1e-9);
  }
}

TEST(EquivalentRadius, DependsOnTheSurfaceAloneToTheBit) {
  const radiation::Solid ball = radiation::sphere(0.03, 3);
  const auto all = ball.radii();
  const std::vector<Index> some = {70, 3, 41};
  const auto found = equivalent_radii(ball.corners(), some);
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(found[i], all[some[i]]);
  }
}

}  // namespace
}  // namespace idiophone::surface
