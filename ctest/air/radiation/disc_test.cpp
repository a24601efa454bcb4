// Flat sources: a piston in a wall, and a disc in the open that moves to and fro.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vibrating_solid.hpp"

namespace idiophone::radiation {
namespace {

using std::numbers::pi;
constexpr double disc_radius = 0.1;                         // m
constexpr double impedance = air_density * test_air.speed;  // Pa s/m

double along_z(const Vector3&, const Vector3& normal) {
  return normal.z();
}

/// Largest difference between the pulse on the piston's axis and the exact one, p = z [v(t - d/c) - v(t -
/// sqrt(d^2 + a^2)/c)], as part of its peak.
double pulse_error(int n) {
  constexpr double distance = 0.15, width = 100e-6, middle = 0.6e-3;  // m, s
  constexpr int samples = 100;
  const auto velocity = [](double time) { return std::exp(-0.5 * std::pow((time - middle) / width, 2)); };
  const auto sound = listen(
      disc(disc_radius, n), [&](const Vector3&, const Vector3&, double time) { return velocity(time); }, rayleigh, {},
      {0, 0, distance}, samples);
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double time = static_cast<double>(i) / test_air.rate;
    const double exact = impedance * (velocity(time - distance / test_air.speed) -
                                      velocity(time - std::hypot(distance, disc_radius) / test_air.speed));
    worst = std::max(worst, std::abs(sound[i] - exact));
  }
  return worst / impedance;
}

TEST(Rayleigh, HearsThePulsesFromAPistonsMiddleAndRim) {
  const double coarse = pulse_error(3), fine = pulse_error(6), finest = pulse_error(12);
  EXPECT_LT(finest, 0.001);
  EXPECT_LT(finest, 0.3 * fine);  // second order: 0.25
  EXPECT_LT(fine, 0.3 * coarse);
}

TEST(Rayleigh, HearsNothingInThePistonsNulls) {
  constexpr double ka = 6.0, distance = 60.0;
  const Solid piston = disc(disc_radius, 20);
  const auto level = [&](double sine) {
    const Vector3 receiver = distance * Vector3(sine, 0.0, std::sqrt(1.0 - sine * sine));
    return std::abs(response(piston, along_z, rayleigh, {}, receiver, ka * test_air.speed / (2.0 * pi * disc_radius)));
  };
  const double on_axis = level(0.0);
  EXPECT_NEAR(decibels(on_axis, impedance * ka * disc_radius / (2.0 * distance)), 0.0, 0.1);
  const double null = 3.8317 / ka;
  EXPECT_LT(decibels(level(null), on_axis), -45.0);
  EXPECT_GT(decibels(level(0.95 * null), on_axis), -35.0);
  EXPECT_GT(decibels(level(1.05 * null), on_axis), -35.0);
}

TEST(Rayleigh, DoesNotHearWhatLooksAway) {
  EXPECT_EQ(std::abs(response(disc(disc_radius, 4), along_z, rayleigh, {}, {0.1, 0, -1}, 1000.0)), 0.0);
}

class OpenDisc : public testing::Test {
 protected:
  static constexpr double distance = 3.0;

  [[nodiscard]] double level(const Model& model, std::optional<Field> field, double ka, double degrees) const {
    const double angle = degrees * pi / 180.0;
    const Vector3 receiver = distance * Vector3(std::sin(angle), 0.0, std::cos(angle));
    return std::abs(response(disc_, along_z, model, field, receiver, ka * test_air.speed / (2.0 * pi * disc_radius)));
  }

 private:
  Solid disc_ = disc(disc_radius, 12, disc_radius / 50.0);
};

TEST_F(OpenDisc, IsHeardByItsAddedMassAtLowFrequencies) {
  // The air's force on a thin disc is (8/3) rho a^3 times its acceleration; a dipole of that strength radiates
  // |p| = 2/(3 pi) z (ka)^2 a |v| cos(theta)/r, near terms apart.
  for (const double ka : {0.05, 0.1, 0.2}) {
    const double near = std::hypot(1.0, disc_radius / (ka * distance));
    const double exact = 2.0 / (3.0 * pi) * impedance * ka * ka * disc_radius / distance * near;
    EXPECT_NEAR(decibels(level(kirchhoff, Field::oscillating, ka, 0.0), exact), 0.7, 0.15) << ka;
  }
}

TEST_F(OpenDisc, RisesBySixDecibelsAnOctaveMoreThanInAWall) {
  EXPECT_NEAR(decibels(level(rayleigh, {}, 0.4, 0.0), level(rayleigh, {}, 0.2, 0.0)), 6.0, 0.2);
  EXPECT_NEAR(decibels(level(kirchhoff, Field::oscillating, 0.4, 0.0), level(kirchhoff, Field::oscillating, 0.2, 0.0)),
              12.0, 0.8);
}

TEST_F(OpenDisc, IsADipole) {
  for (const std::optional<Field> field : {std::optional<Field>(), std::optional(Field::oscillating)}) {
    const double on_axis = level(kirchhoff, field, 0.3, 0.0);
    EXPECT_NEAR(decibels(level(kirchhoff, field, 0.3, 180.0), on_axis), 0.0, 1e-3);
    EXPECT_NEAR(decibels(level(kirchhoff, field, 0.3, 60.0), on_axis), -6.0, 0.1);
    EXPECT_LT(decibels(level(kirchhoff, field, 0.3, 90.0), on_axis), -80.0);  // in its plane
  }
}

}  // namespace
}  // namespace idiophone::radiation
