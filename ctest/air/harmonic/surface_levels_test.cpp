// Refined surfaces, and the estimate of the error of a level.

#include "surface_levels.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "vibrating_solid.hpp"

namespace idiophone::harmonic {
namespace {

using radiation::quiet_air;

double area_of(const Boundary& boundary) {
  return radiation::Solid{boundary.triangles, boundary.vertices}.area();
}

TEST(RefinedSurface, IsTheSameSurfaceWithFourTimesTheTriangles) {
  const radiation::Solid solid = radiation::box({0.3, 0.2, 0.1}, {3, 2, 1});
  const Boundary coarse{solid.vertices, solid.triangles, {}};
  const Boundary fine = refined(coarse).boundary;
  EXPECT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
  EXPECT_EQ(fine.vertices.size(), coarse.vertices.size() + 3 * coarse.triangles.size() / 2);
  EXPECT_NEAR(area_of(fine), area_of(coarse), 1e-12);
  EXPECT_TRUE(std::ranges::equal(coarse.vertices, std::span(fine.vertices).first(coarse.vertices.size())));
}

TEST(RefinedSurface, KeepsQuadraticFieldsOnEachFace) {
  const radiation::Solid solid = radiation::box({0.3, 0.2, 0.1}, {4, 4, 4});
  const RefinedBoundary fine = refined({solid.vertices, solid.triangles, {}});
  const auto field = [](const Vector3& x) {
    return ComplexVector(x.x() * x.y(), x.z() * x.z() - x.y(), Complex(1.0 + x.x(), x.y()));
  };
  std::vector<ComplexVector> values;
  std::ranges::transform(solid.vertices, std::back_inserter(values), field);
  const std::vector<ComplexVector> all = at_vertices(fine, values);
  ASSERT_EQ(all.size(), fine.boundary.vertices.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    EXPECT_LT((all[v] - field(fine.boundary.vertices[v])).norm(), 1e-6);
  }
}

constexpr double side = 0.2;         // m
constexpr double wave_number = 3.0;  // 1/m

/// A plate of glass in torsion: both faces move with x y, which radiates weakly.
Boundary plate(int cells) {
  radiation::Solid solid = radiation::box({side, side, 0.003}, {cells, cells, 1});
  return {std::move(solid.vertices), std::move(solid.triangles), {}};
}

double twist(const Vector3& place) {
  return place.x() * place.y() / (side * side);
}

std::vector<std::vector<ComplexVector>> torsion_of(const Boundary& boundary) {
  std::vector<ComplexVector> values;
  for (const Vector3& vertex : boundary.vertices) {
    values.emplace_back(0.0, 0.0, twist(vertex));
  }
  return {values};
}

/// Linear in each triangle, with the mean that the torsion has there.
std::vector<std::vector<Complex>> exact_flow(const Boundary& boundary) {
  std::vector<Complex> values;
  for (const auto& triangle : boundary.triangles) {
    const std::array<Vector3, 3> corners = {boundary.vertices[triangle[0]], boundary.vertices[triangle[1]],
                                            boundary.vertices[triangle[2]]};
    const auto& [a, b, c] = corners;
    const double normal = (b - a).cross(c - a).normalized().z();
    const double mean = (twist((a + b) / 2.0) + twist((b + c) / 2.0) + twist((c + a) / 2.0)) / 3.0;
    const double correction = mean - (twist(a) + twist(b) + twist(c)) / 3.0;
    for (const Vector3& corner : corners) {
      values.emplace_back(normal * (twist(corner) + correction));
    }
  }
  return {values};
}

double level(double power) {
  return 10.0 * std::log10(power);
}

TEST(RefinedSolution, HasTheLevelOfAFineSurfaceWithinItsErrorForATorsionMode) {
  const Boundary fine = plate(18);
  const double reference = level(BoundaryElements(fine, quiet_air).solve(wave_number, exact_flow(fine)).front().power);
  constexpr double tolerance = 1.5;  // dB: a smaller one takes longer
  const Boundary coarse = plate(4);
  SurfaceLevels levels(coarse, quiet_air, 1000);
  std::vector<Complex> linear;
  for (const auto& triangle : coarse.triangles) {
    const Vector3& first = coarse.vertices[triangle[0]];
    const Vector3 normal =
        (coarse.vertices[triangle[1]] - first).cross(coarse.vertices[triangle[2]] - first).normalized();
    for (const Index vertex : triangle) {
      linear.emplace_back(normal.z() * twist(coarse.vertices[vertex]));
    }
  }
  const std::vector<std::vector<Complex>> unrefined = {linear};
  EXPECT_GT(level(BoundaryElements(coarse, quiet_air).solve(wave_number, unrefined).front().power) - reference, 20.0);
  EXPECT_TRUE(std::isnan(solve_refined(levels, wave_number, torsion_of(coarse), 0.0).level_error.front()));
  const RefinedSolution solution = solve_refined(levels, wave_number, torsion_of(coarse), tolerance);
  EXPECT_LE(solution.level_error.front(), tolerance);
  EXPECT_NEAR(level(solution.fields.front().power), reference, solution.level_error.front());
  EXPECT_GT(solution.elements->boundary().vertices.size(), coarse.vertices.size());
}

TEST(RefinedSolution, SaysThatTheErrorIsUnknownWhereTheSurfaceMayNotBeRefined) {
  const Boundary coarse = plate(2);
  SurfaceLevels levels(coarse, quiet_air, coarse.vertices.size());
  EXPECT_TRUE(std::isnan(solve_refined(levels, wave_number, torsion_of(coarse), 0.5).level_error.front()));
}

}  // namespace
}  // namespace idiophone::harmonic
