#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "idiophone/air/radiation/radiation.hpp"
#include "vibrating_solid.hpp"

namespace idiophone::radiation {
namespace {

using surface::Emission;

/// Sets one triangle of an emission.
void set(Emission& emission, std::size_t i, double pressure, double area, const Vector3& centre,
         const Vector3& normal) {
  emission.pressure[i] = pressure;
  emission.area[i] = area;
  for (int axis = 0; axis < 3; ++axis) {
    emission.centre[axis][i] = centre[axis];
    emission.normal[axis][i] = normal[axis];
  }
}

Emission one(double pressure, double area, const Vector3& centre, const Vector3& normal) {
  Emission emission;
  emission.resize(8);
  set(emission, 0, pressure, area, centre, normal);
  return emission;
}

Arrivals radiate(const Emission& emission, const Vector3& receiver, const Medium& air = {}) {
  Paths paths;
  find_paths(emission, {.position = receiver}, air, paths);
  Arrivals arrivals;
  Huygens().radiate(emission, paths, arrivals);
  return arrivals;
}

TEST(Huygens, IsEquations10And11) {
  // The receiver is (1, 2, 2) from the centre, R = 3; cos(theta) with the normal (0, 0.6, 0.8) is 2.8/3.
  const auto arrivals = radiate(one(5.0, 2e-4, {1, 1, 1}, {0, 0.6, 0.8}), {2, 3, 3}, {.speed = 300.0, .rate = 48000});
  EXPECT_NEAR(arrivals.sound[0], 5.0 * 2e-4 / 3.0 * (2.8 / 3.0), 1e-18);
  EXPECT_NEAR(arrivals.delay[0], 3.0 / 300.0 * 48000.0, 1e-11);
}

TEST(Huygens, IsSilentBehindATriangle) {
  EXPECT_EQ(radiate(one(5.0, 1.0, {0, 0, 0}, {0, 0, 1}), {0.1, 0, -1}).sound[0], 0.0);
  EXPECT_NE(radiate(one(5.0, 1.0, {0, 0, 0}, {0, 0, 1}), {0.1, 0, 1}).sound[0], 0.0);
}

TEST(Huygens, StaysFiniteOnATrianglesCentre) {
  const auto on = radiate(one(5.0, 1.0, {1, 2, 3}, {0, 0, 1}), {1, 2, 3});
  EXPECT_EQ(on.sound[0], 0.0);
  EXPECT_GE(on.delay[0], 0.0);
  const auto near = radiate(one(5.0, 1.0, {1, 2, 3}, {0, 0, 1}), {1, 2, 3 + 1e-9});
  EXPECT_GT(near.sound[0], 0.0);
  EXPECT_LE(near.sound[0], 5.0 / smallest_distance);
}

TEST(Huygens, PassesNotANumberOn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(radiate(one(nan, 1.0, {0, 0, 0}, {0, 0, 1}), {0, 0, -1}).sound[0]));
  EXPECT_TRUE(std::isnan(radiate(one(1.0, 1.0, {0, nan, 0}, {0, 0, 1}), {0, 0, -1}).sound[0]));
}

TEST(Huygens, GivesATriangleTheSameBitsInAnyLane) {
  Emission emission;
  emission.resize(16);
  for (std::size_t i = 0; i < 16; ++i) {
    set(emission, i, 1.0 / 3.0, 1e-4 / 7.0, {0.1, 0.2, 0.3}, {0.36, 0.48, 0.8});
  }
  const auto arrivals = radiate(emission, {0.5, 0.7, 1.1});
  for (std::size_t i = 1; i < 16; ++i) {
    EXPECT_EQ(arrivals.sound[i], arrivals.sound[0]);
    EXPECT_EQ(arrivals.delay[i], arrivals.delay[0]);
  }
}

/// A sphere that pulsates with z |v| = 1 Pa.
Emission pulsating_sphere(double a, int n) {
  const auto corners = sphere(a, n).corners();
  Emission emission;
  emission.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [p, q, r] = corners[i];
    const Vector3 twice_area = (q - p).cross(r - p);
    set(emission, i, 1.0, twice_area.norm() / 2.0, (p + q + r) / 3.0, twice_area.normalized());
  }
  return emission;
}

TEST(Huygens, SumsAPulsatingSphereToPiASquaredOverR) {
  const double a = 0.05, r = 4.0;
  // Relative error of the sum; also 1/R differs over the sphere, by about a/r: exactly, for cos clipped at 0,
  // 2 pi a^2 times the integral of (r mu - a)/(r^2 + a^2 - 2 a r mu) over mu from a/r to 1.
  constexpr int intervals = 20000;
  double exact = 0.0;
  for (int i = 0; i < intervals; ++i) {
    const double mu = a / r + (1.0 - a / r) * (i + 0.5) / intervals;
    exact +=
        2.0 * std::numbers::pi * a * a * (r * mu - a) / (r * r + a * a - 2.0 * a * r * mu) * (1.0 - a / r) / intervals;
  }
  EXPECT_NEAR(exact / (std::numbers::pi * a * a / r), 1.0, 2.0 * a / r);
  std::array<double, 3> errors{};
  for (std::size_t level = 0; level < errors.size(); ++level) {
    const auto arrivals = radiate(pulsating_sphere(a, 8 << level), r * Vector3(2, 3, 6) / 7.0);
    errors[level] = std::abs(std::accumulate(arrivals.sound.begin(), arrivals.sound.end(), 0.0) / exact - 1.0);
  }
  EXPECT_LT(errors[0], 0.03);
  EXPECT_GT(errors[0] / errors[1], 3.0);  // second order: 4 each time
  EXPECT_GT(errors[1] / errors[2], 3.0);
}

}  // namespace
}  // namespace idiophone::radiation
