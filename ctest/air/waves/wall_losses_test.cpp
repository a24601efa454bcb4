// What walls take from the sound: half a derivative, the area of walls, and the resonance of a tube.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "half_derivative.hpp"
#include "idiophone/air/waves/cut_cells.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"
#include "ringing.hpp"
#include "tube.hpp"

namespace idiophone::waves {
namespace {

using std::numbers::pi;

ON_RANKS(1);

TEST(HalfDerivative, IsTheSquareRootOfTheFrequency) {
  constexpr double step = 5e-6;   // s
  constexpr float ratio = 1e-4F;  // so small that it hardly changes the quantity
  for (const double frequency : {20.0, 100.0, 440.0, 3000.0, 10000.0}) {
    HalfDerivative half({ratio}, step);
    std::vector<float> gain(half.length()), loss(half.length()), value(half.length());
    const double turn = 2.0 * pi * frequency * step;
    const auto period = static_cast<int>(std::lround(2.0 * pi / turn));
    Complex taken = 0.0;
    for (int i = 0; i < 40 * period; ++i) {
      value[0] = static_cast<float>(std::sin(turn * i));
      gain[0] = static_cast<float>(std::sin(turn * (i + 1)) - std::sin(turn * i));
      half.losses(value, gain, loss);
      half.advance(value, gain, loss);
      if (i >= 20 * period) {  // a sine's amplitude is -i; half a step later
        taken += 2.0 / (20 * period) * loss[0] * std::exp(Complex(0.0, -turn * (i + 0.5)));
      }
    }
    const Complex expected = Complex(0.0, -1.0) * std::sqrt(Complex(0.0, turn)) * static_cast<double>(ratio);
    EXPECT_LT(std::abs(taken / expected - 1.0), 0.02) << frequency << " Hz: " << taken / expected;
  }
}

TEST(WallShares, AreTheAreaOfASphereAndWhatRubsOnIt) {
  const radiation::Solid sphere = radiation::icosphere(0.05, 4);
  const auto positions = positions_of(sphere, Vector3(0.001, 0.002, -0.003));
  const Grid grid{.corner = Vector3(-0.163, -0.141, -0.152), .cell = 0.01, .cells = {32, 28, 30}, .layer = 6};
  const CutCells cells(Subdomain(grid, grid.all()), {sphere.triangles, positions}, 0.55, true);
  double area = 0.0;
  for (const WallShare& share : cells.walls()) {
    area += share.area * grid.cell * grid.cell;
  }
  EXPECT_NEAR(area / (4.0 * pi * 0.05 * 0.05), 1.0, 0.01);
  EXPECT_TRUE(CutCells(Subdomain(grid, grid.all()), {sphere.triangles, positions}, 0.55).walls().empty());
}

constexpr double tube_radius = 0.0205, tube_length = 0.1822, tube_wall = 0.005;  // m
constexpr LossyAir tube_air = lossy_air(speed, impedance / speed, 20.0);

/// The first resonance of the tube in this air: exp(i w t) with a complex w, 1/s. The inside conducts heat, the bottom,
/// too, and rubs (Kirchhoff 1868, wide tubes). Radiation takes (k radius)^2/4 (Levine and Schwinger 1948).
Complex resonance_of_tube(const LossyAir& air) {
  Complex found(2.0 * pi * 440.0, 20.0);
  const auto equation = [&air](Complex w) {
    const Complex iw = Complex(0.0, 1.0) * w;
    const Complex friction = 2.0 / tube_radius * std::sqrt(air.viscosity / iw);
    const Complex heat = (air.heat_ratio - 1.0) * std::sqrt(air.diffusivity / iw);
    const Complex k = w / speed * std::sqrt((1.0 + 2.0 / tube_radius * heat) / (1.0 - friction));
    const Complex impedance_of_tube = 1.0 / std::sqrt((1.0 + 2.0 / tube_radius * heat) * (1.0 - friction));
    const Complex still = w / speed;
    const Complex end =
        std::pow(still * tube_radius, 2) / 4.0 +
        Complex(0.0, 1.0) * still * end_correction(tube_radius, tube_radius + tube_wall, w.real() / (2.0 * pi));
    return Complex(0.0, 1.0) * impedance_of_tube / std::tan(k * (tube_length + heat)) - end;
  };
  for (int i = 0; i < 50; ++i) {
    const Complex small(0.01, 0.0);
    const Complex slope = (equation(found + small) - equation(found - small)) / (2.0 * small);
    found -= equation(found) / slope;
  }
  return found;
}

TEST(WallLosses, GiveATubeItsQuality) {
  LONG_VERIFICATION();
  const Complex exact = resonance_of_tube(tube_air);
  const double frequency = exact.real() / (2.0 * pi), quality = exact.real() / (2.0 * exact.imag());
  const Recording heard = record(closed_tube(tube_radius, tube_length, tube_wall), tube_wall, 0.004,
                                 Vector3(0.0, 0.0, tube_wall + 0.02), 0.031, tube_air);
  constexpr double start = 0.006, later = 0.009, window = 0.016;  // s
  const double decay = std::log(std::abs(spectrum(heard, start, window, frequency)) /
                                std::abs(spectrum(heard, start + later, window, frequency))) /
                       later;
  RecordProperty("Q", std::to_string(pi * frequency / decay));
  EXPECT_NEAR(pi * frequency / decay, quality, 0.03 * quality);
  EXPECT_NEAR(frequency_near(heard, frequency, window), frequency, 0.006 * frequency);
  EXPECT_NEAR(quality, 64.4, 0.1);  // 117.9 without losses
}

}  // namespace
}  // namespace idiophone::waves
