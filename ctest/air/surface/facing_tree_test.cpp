#include "facing_tree.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

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

Triangles ellipsoid(const Vector3& axes) {
  return surface_of(60, 120, [&](double u, double v) -> Vector3 {
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

/// The largest difference from the direct sum, relative to it.
double largest_error(const Triangles& surface) {
  const FacingTree tree(surface);
  FacingColumns columns(surface.size());
  for (std::size_t number = 0; number < surface.size(); ++number) {
    columns.put(number, flat_piece(surface[number]));
  }
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
  constexpr double most = 5e-4;
  EXPECT_LT(largest_error(ellipsoid({1.0, 1.0, 1.0})), most);
  EXPECT_LT(largest_error(ellipsoid({1.0, 0.7, 0.01})), most);  // both sides of a sheet
  EXPECT_LT(largest_error(ring()), most);                       // hollows see themselves
}

}  // namespace
}  // namespace idiophone::surface
