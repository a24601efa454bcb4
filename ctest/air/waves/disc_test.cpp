// A thin disc that oscillates along its axis, slowly enough for Lamb's added mass.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "long_verification.hpp"
#include "ranks.hpp"
#include "ringing.hpp"

namespace idiophone::waves {
namespace {

constexpr double disc_radius = 0.1;  // m
constexpr double thick = 0.004;      // m
constexpr double film = 2e-5;        // m: a fiftieth of a sub-voxel

/// What the thickness adds to a disc without thickness and the air that it displaces, dB: boundary elements of 16 rings
/// find 0.413, of 12 rings 0.398.
constexpr double by_thickness = 0.43;

/// Far pressure on the axis of a dipole whose force moves the added mass 8/3 rho a^3 and the displaced air.
double exact(double thickness, double frequency, double distance) {
  const double k = 2.0 * std::numbers::pi * frequency / speed;
  const double volume = 8.0 / 3.0 * std::pow(disc_radius, 3) + std::numbers::pi * disc_radius * disc_radius * thickness;
  return impedance * k * k * volume / (4.0 * std::numbers::pi * distance) * std::hypot(1.0, 1.0 / (k * distance));
}

constexpr double disc_cell = 0.008;  // m

/// Errors at 60 and 100 Hz, dB.
/// @param lowest  z of the lowest vertex, m: the grid begins 0.29 and some whole cells below it
std::vector<double> errors(double thickness, const Eigen::Matrix3d& turn, double lowest = 0.0) {
  auto disc = radiation::disc(disc_radius, 16, thickness);
  for (Vector3& vertex : disc.vertices) {
    vertex = turn * vertex;
  }
  if (lowest < 0.0) {
    disc.vertices.emplace_back(0, 0, lowest);  // of no triangle
  }
  const Vector3 axis = turn.col(2);
  const std::array frequencies = {60.0, 100.0};
  const std::array points = {axis};
  const Responses heard = ring({.solid = disc,
                                .cell = disc_cell,
                                .shape = [&axis](const Vector3&, const Vector3& normal) { return normal.dot(axis); }},
                               frequencies, points);
  std::vector<double> all;
  for (std::size_t f = 0; f < frequencies.size(); ++f) {
    all.push_back(20.0 * std::log10(std::abs(heard[f][0]) / exact(thickness, frequencies[f], 1.0)));
  }
  return all;
}

ON_RANKS(1);

TEST(Disc, HasTheAddedMassOfLamb) {
  for (const double error : errors(thick, Eigen::Matrix3d::Identity())) {
    EXPECT_NEAR(error, by_thickness, 0.4);
  }
}

TEST(Disc, HasItThinnerThanASubVoxel) {
  for (const double error : errors(film, Eigen::Matrix3d::Identity())) {
    EXPECT_NEAR(error, 0.0, 0.15);
  }
}

TEST(Disc, IsTooLoudInTheOutermostEighthOfACell) {  // docs/use/waves.md#sheets
  const auto at_place = [](double place) {
    return errors(film, Eigen::Matrix3d::Identity(), (0.29 - place - 1.0) * disc_cell).front();
  };
  for (const double place : {0.06, 0.94}) {
    EXPECT_NEAR(at_place(place), 0.55, 0.02);
  }
  for (const double place : {0.19, 0.81}) {
    EXPECT_NEAR(at_place(place), 0.11, 0.02);
  }
}

TEST(Disc, HasItTilted) {
  LONG_VERIFICATION();
  for (const double error : errors(thick, Eigen::AngleAxisd(0.6, Vector3(1, 2, 0.5).normalized()).toRotationMatrix())) {
    EXPECT_NEAR(error, by_thickness, 0.15);
  }
}

TEST(Disc, HasItThinAndTilted) {
  LONG_VERIFICATION();
  for (const double error : errors(film, Eigen::AngleAxisd(0.6, Vector3(1, 2, 0.5).normalized()).toRotationMatrix())) {
    EXPECT_NEAR(error, 0.0, 0.3);
  }
}

}  // namespace
}  // namespace idiophone::waves
