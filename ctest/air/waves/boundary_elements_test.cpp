// Solids of other shapes, straight and tilted against the grid, against boundary elements.

#include "idiophone/air/harmonic/boundary_elements.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "blocks.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"
#include "ringing.hpp"

namespace idiophone::waves {
namespace {

using Shape = std::function<double(const Vector3& place, const Vector3& normal)>;

const std::array<Vector3, 5> directions = {Vector3(1, 0, 0), Vector3(0.6, 0, 0.8), Vector3(0, 0, 1),
                                           Vector3(-0.48, 0.64, 0.6), Vector3(0.36, -0.48, -0.8)};

struct Case {
  radiation::Solid solid;
  double cell;
  Shape shape;
  std::vector<double> frequencies;
};

Case tilted(Case straight) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, Vector3(1, 2, 0.5).normalized()).toRotationMatrix();
  for (Vector3& vertex : straight.solid.vertices) {
    vertex = turn * vertex;
  }
  straight.shape = [turn, shape = straight.shape](const Vector3& place, const Vector3& normal) {
    return shape(turn.transpose() * place, turn.transpose() * normal);
  };
  return straight;
}

std::vector<Complex> by_boundary_elements(const Case& one, double frequency) {
  const harmonic::BoundaryElements elements({one.solid.vertices, one.solid.triangles},
                                            {.density = impedance / speed, .speed = speed});
  std::vector<std::vector<Complex>> velocity(1);
  for (const auto& [a, b, c] : one.solid.corners()) {
    const Vector3 normal = (b - a).cross(c - a).normalized();
    for (const Vector3& corner : {a, b, c}) {
      velocity[0].emplace_back(one.shape(corner, normal));
    }
  }
  const auto field = elements.solve(2.0 * std::numbers::pi * frequency / speed, velocity).front();
  return elements.pressure_at(field, directions);
}

void expect_within(const Case& one, double decibels) {
  const Responses heard = ring({.solid = one.solid, .cell = one.cell, .shape = one.shape}, one.frequencies, directions);
  for (std::size_t f = 0; f < one.frequencies.size(); ++f) {
    const double error = level(heard[f], by_boundary_elements(one, one.frequencies[f]));
    testing::Test::RecordProperty("dB at " + std::to_string(one.frequencies[f]), std::to_string(error));
    EXPECT_NEAR(error, 0.0, decibels) << one.frequencies[f] << " Hz";
  }
}

Case cube() {
  return {radiation::box(Vector3::Constant(0.1), {6, 6, 6}),
          0.008,
          [](const Vector3&, const Vector3& normal) { return normal[0]; },
          {200.0, 1000.0, 2000.0}};
}

/// The twisting mode of a free plate. It is as thick as the boundary elements are long, which they need.
Case plate() {
  return {radiation::box(Vector3(0.3, 0.3, 0.02), {12, 12, 1}),
          0.008,
          [](const Vector3& place, const Vector3& normal) { return normal[2] * place[0] * place[1]; },
          {1000.0}};
}

/// A slender bar that moves to and fro across its length, along x or y; its section is three by four cells.
Case bar(Eigen::Index axis) {
  return {radiation::box(Vector3(0.0225, 0.03, 0.1), {3, 4, 14}),
          0.0075,
          [axis](const Vector3&, const Vector3& normal) { return normal[axis]; },
          {100.0, 300.0}};
}

/// Adds a solid, shifted along z.
void add(radiation::Solid& solids, const radiation::Solid& other, double height) {
  const auto first = static_cast<Index>(solids.vertices.size());
  for (const Vector3& vertex : other.vertices) {
    solids.vertices.emplace_back(vertex + Vector3(0.0, 0.0, height));
  }
  for (const auto& [a, b, c] : other.triangles) {
    solids.triangles.push_back({first + a, first + b, first + c});
  }
}

/// A ball that pulsates behind a screen, which stands still.
Case screen() {
  Case both{radiation::box(Vector3(0.2, 0.2, 0.016), {8, 8, 1}),
            0.008,
            [](const Vector3& place, const Vector3&) { return place[2] < -0.04 ? 1.0 : 0.0; },
            {500.0, 1500.0}};
  add(both.solid, radiation::icosphere(0.03, 2), -0.08);
  return both;
}

/// A box without a lid that moves to and fro along x. Its cavity rings for 20 ms.
Case open_box() {
  constexpr double wall = 0.005;
  constexpr int parts = 4;
  const auto planes = [](double low, double high, bool has_wall_above) {
    std::vector<double> places = {low};
    const double inside = high - low - (has_wall_above ? 2.0 : 1.0) * wall;
    for (int i = 0; i <= parts; ++i) {
      places.push_back(low + wall + inside * i / parts);
    }
    if (has_wall_above) {
      places.push_back(high);
    }
    return places;
  };
  return {of_blocks({planes(-0.05, 0.05, true), planes(-0.04, 0.04, true), planes(-0.03, 0.03, false)},
                    [](const Vector3& place) {
                      return std::abs(place[0]) > 0.045 || std::abs(place[1]) > 0.035 || place[2] < -0.025;
                    }),
          wall,
          [](const Vector3&, const Vector3& normal) { return normal[0]; },
          {100.0, 300.0}};
}

/// Two balls that rebound from each other, half a cell apart.
Case balls() {
  constexpr double radius = 0.03, gap = 0.002;
  Case both{{},
            0.004,
            [](const Vector3& place, const Vector3& normal) { return std::copysign(normal[2], place[2]); },
            {500.0, 1500.0, 3000.0}};
  for (const double height : {radius + gap / 2.0, -radius - gap / 2.0}) {
    add(both.solid, radiation::icosphere(radius, 4), height);
  }
  return both;
}

ON_RANKS(1);

TEST(AgainstBoundaryElements, Cube) {
  expect_within(cube(), 0.5);
}

TEST(AgainstBoundaryElements, TiltedCube) {
  expect_within(tilted(cube()), 0.5);
}

TEST(AgainstBoundaryElements, Screen) {
  expect_within(screen(), 0.5);
}

TEST(AgainstBoundaryElements, SlenderBar) {
  expect_within(bar(0), 0.5);
  expect_within(bar(1), 0.5);
}

TEST(AgainstBoundaryElements, OpenBox) {
  LONG_VERIFICATION();
  expect_within(open_box(), 0.25);
}

TEST(AgainstBoundaryElements, CollidingBalls) {
  expect_within(balls(), 0.5);
}

TEST(AgainstBoundaryElements, TwistingPlate) {
  expect_within(plate(), 0.5);
}

TEST(AgainstBoundaryElements, TiltedPlate) {
  expect_within(tilted(plate()), 0.5);
}

}  // namespace
}  // namespace idiophone::waves
