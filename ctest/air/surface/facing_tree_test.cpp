#include "facing_tree.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "idiophone/air/surface/equivalent_radius.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

using std::numbers::pi;
using Triangles = std::vector<std::array<Vector3, 3>>;

/// A closed surface over a rectangle of parameters, in 2 x across x along triangles.
template <class Place>
Triangles surface_of(int across, int along, const Place& place) {
  Triangles triangles;
  const auto at = [&](int i, int j) { return place(double(i) / across, double(j) / along); };
  const auto add = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    if ((b - a).cross(c - a).norm() > 1e-12) {
      triangles.push_back({a, b, c});
    }
  };
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < along; ++j) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return triangles;
}

Triangles ellipsoid(const Vector3& axes, int across = 60, int along = 120) {
  return surface_of(across, along, [&](double u, double v) -> Vector3 {
    const Vector3 direction(std::sin(pi * u) * std::cos(2 * pi * v), std::sin(pi * u) * std::sin(2 * pi * v),
                            std::cos(pi * u));
    return direction.cwiseProduct(axes);
  });
}

Triangles ring() {
  return surface_of(60, 120, [](double u, double v) -> Vector3 {
    const double radius = 1.0 + 0.3 * std::cos(2 * pi * u);
    return {radius * std::sin(2 * pi * v), radius * std::cos(2 * pi * v), 0.3 * std::sin(2 * pi * u)};
  });
}

Triangles slanted_plate() {
  Triangles plate = ellipsoid({1.0, 1.0, 0.01});
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), Vector3::Ones());
  for (auto& triangle : plate) {
    std::ranges::transform(triangle, triangle.begin(), [&](const Vector3& corner) -> Vector3 { return turn * corner; });
  }
  return plate;
}

/// The largest difference from the direct sum, relative to it.
double largest_error(const Triangles& surface) {
  const FacingTree tree(surface);
  const FacingColumns columns = columns_of(surface);
  double largest = 0.0;
  for (std::size_t number = 0; number < surface.size(); number += 7) {
    const FlatPiece piece = flat_piece(surface[number]);
    const double direct = columns.sum(piece, 0, columns.fours());
    largest = std::max(largest, std::abs(tree.sum(piece) / direct - 1.0));
  }
  return largest;
}

ON_RANKS(1);

TEST(FacingTree, HasTheSumsOfAllTriangles) {
  constexpr double most = 1e-3;
  EXPECT_LT(largest_error(ellipsoid({1.0, 1.0, 1.0})), most);
  EXPECT_LT(largest_error(ellipsoid({1.0, 0.7, 0.01})), most);  // both sides of a sheet
  EXPECT_LT(largest_error(ring()), most);                       // hollows see themselves
  EXPECT_LT(largest_error(slanted_plate()), most);              // one face is nearest to three axes
}

/// Triangles in a cube: most of them face one way, and some another that is nearly opposite. Both are nearest to the x
/// axis.
Triangles scattered() {
  const Vector3 most = Vector3(1.1, 1, 1).normalized(), some = Vector3(1.1, -1, -1).normalized();
  Triangles triangles;
  for (int number = 0; number < 4000; ++number) {
    const Vector3 place(std::fmod(0.7549 * number, 1.0), std::fmod(0.5698 * number, 1.0),
                        std::fmod(0.3247 * number, 1.0));
    const Vector3 normal = number % 20 == 0 ? some : most;
    const Vector3 one = 0.01 * normal.unitOrthogonal();
    triangles.push_back({place, place + one, place + normal.cross(one)});
  }
  return triangles;
}

TEST(FacingTree, FindsWhatFacesAnotherWayThanItsCluster) {
  const Triangles surface = scattered();
  const FacingTree tree(surface);
  const FacingColumns columns = columns_of(surface);
  for (const Vector3& normal : {Vector3(-1.1, -1, -1), Vector3(-1, -1, -1), Vector3(1, -2, -2), Vector3(1, 0, 0)}) {
    const FlatPiece piece{Vector3(0.4, 0.5, 0.6), 1e-4 * normal.normalized()};
    const double direct = columns.sum(piece, 0, columns.fours());
    ASSERT_GT(direct, 0.0);
    EXPECT_NEAR(tree.sum(piece), direct, 5e-3 * direct) << normal.transpose();
  }
}

/// A sphere's is its radius.
TEST(FacingTree, GivesTheRadiiOfLargeSurfaces) {
  const Triangles sphere = ellipsoid({1.0, 1.0, 1.0}, 160, 180);
  ASSERT_GT(sphere.size(), 50000U);
  const std::vector<Index> which = {77, 12345, 40000};
  const std::vector<double> radii = equivalent_radii(sphere, which);
  ASSERT_EQ(radii.size(), which.size());
  for (const double radius : radii) {
    EXPECT_NEAR(radius, 1.0, 0.01);
  }
}

}  // namespace
}  // namespace idiophone::surface
