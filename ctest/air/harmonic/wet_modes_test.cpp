// Modes of a sphere with air, whose mass and resistance are known exactly.

#include "idiophone/air/harmonic/wet_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "vibrating_solid.hpp"

namespace idiophone::harmonic {
namespace {

using radiation::quiet_air;
using std::numbers::pi;

constexpr double radius = 0.05;                                                   // m
constexpr double sphere_mass = 20.0 * 4.0 / 3.0 * pi * radius * radius * radius;  // of foam, kg

/// Force of the air over the velocity, N s/m: of a sphere that oscillates, and of one that pulsates (Morse and Ingard,
/// Theoretical Acoustics, section 7.2).
Complex impedance_of_oscillation(double angular) {
  const Complex x(0.0, angular * radius / quiet_air.speed);
  return 4.0 / 3.0 * pi * radius * radius * quiet_air.impedance() * x * (1.0 + x) / (2.0 + 2.0 * x + x * x);
}
Complex impedance_of_pulsation(double angular) {
  const Complex x(0.0, angular * radius / quiet_air.speed);
  return 4.0 * pi * radius * radius * quiet_air.impedance() * x / (1.0 + x);
}

struct Exact {
  double frequency, radiation_decay;  // Hz, 1/s
};

/// One mode of unit modal mass.
template <class Impedance>
Exact exact(double dry, const Impedance& impedance) {
  double angular = 2.0 * pi * dry;
  for (int i = 0; i < 50; ++i) {
    angular = 2.0 * pi * dry / std::sqrt(1.0 + impedance(angular).imag() / angular / sphere_mass);
  }
  const double mass = sphere_mass + impedance(angular).imag() / angular;
  return {angular / (2.0 * pi), impedance(angular).real() / (2.0 * mass)};
}

/// A sphere that oscillates along z and pulsates, in this order, by the given factors.
DryModes sphere_modes(const std::vector<std::array<double, 2>>& factors, std::vector<double> frequencies) {
  const radiation::Solid solid = radiation::icosphere(radius, 5);
  DryModes dry{.nodes = solid.vertices,
               .triangles = solid.triangles,
               .shapes = {},
               .frequencies = std::move(frequencies),
               .decays = std::vector(factors.size(), 1.0)};
  for (const auto& [oscillation, pulsation] : factors) {
    auto& shape = dry.shapes.emplace_back();
    for (const Vector3& node : solid.vertices) {
      const Vector3 motion = (oscillation * Vector3::UnitZ() + pulsation * node / radius) / std::sqrt(sphere_mass);
      shape.insert(shape.end(), motion.begin(), motion.end());
    }
  }
  return dry;
}

TEST(WetModes, HaveTheMassAndTheResistanceOfTheAirOfASphere) {
  const DryModes dry = sphere_modes({{1, 0}, {0, 1}}, {400.0, 900.0});
  const std::vector<WetMode> wet = wet_modes(dry, quiet_air);
  ASSERT_EQ(wet.size(), 2);
  const std::array<Exact, 2> expected = {exact(400.0, impedance_of_oscillation), exact(900.0, impedance_of_pulsation)};
  for (std::size_t m = 0; m < 2; ++m) {
    const double shift = cents(dry.frequencies[m], expected.at(m).frequency);
    EXPECT_LT(shift, -20.0);
    EXPECT_NEAR(cents(dry.frequencies[m], wet[m].frequency), shift, 0.02 * -shift);
    EXPECT_NEAR(wet[m].radiation_decay / expected.at(m).radiation_decay, 1.0, 0.04);
    EXPECT_NEAR(wet[m].decay, std::pow(wet[m].shares[m], 2), 1e-3);
    EXPECT_NEAR(estimated_shift(dry, m, quiet_air) / -shift, 1.45, 0.45);
  }
}

TEST(WetModes, AreCoupledByTheAir) {
  // Sums and differences of both motions at one frequency: only the air tells them apart.
  const double share = std::sqrt(0.5);
  const std::vector<WetMode> wet =
      wet_modes(sphere_modes({{share, share}, {share, -share}}, {600.0, 600.0}), quiet_air);
  const Exact oscillation = exact(600.0, impedance_of_oscillation), pulsation = exact(600.0, impedance_of_pulsation);
  EXPECT_NEAR(cents(wet[0].frequency, pulsation.frequency), 0.0, 2.0);
  EXPECT_NEAR(cents(wet[1].frequency, oscillation.frequency), 0.0, 2.0);
  EXPECT_NEAR(std::abs(wet[0].shares[0] / wet[0].shares[1]), 1.0, 0.01);
}

TEST(WetModes, StoppedByAWatchTheyAreTheLowest) {
  const DryModes dry = sphere_modes({{1, 0}, {0, 1}}, {400.0, 900.0});
  const auto stop = [](std::size_t done, std::size_t expected) { return done == expected; };
  const std::vector<WetMode> some = wet_modes(dry, quiet_air, stop);
  ASSERT_EQ(some.size(), 1);
  EXPECT_EQ(some[0].frequency, wet_modes(dry, quiet_air)[0].frequency);
}

TEST(WetModes, StopWhereTheSurfaceDoesNotResolveTheSound) {
  const DryModes dry = sphere_modes({{1, 0}, {0, 1}}, {400.0, 30000.0});
  EXPECT_EQ(resolved_modes(dry, quiet_air.speed), 1);
  EXPECT_EQ(wet_modes(dry, quiet_air).size(), 1);
}

}  // namespace
}  // namespace idiophone::harmonic
