// Oscillators, by their Fourier series.

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "measured.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {

namespace {

/// The strongest alias below a quarter of the rate in a wave that has `cycles` (odd) cycles in 8192 samples, dB re its
/// fundamental.
double strongest_alias(const std::string& wave, int cycles) {
  constexpr int samples = 8192;
  const auto sound = sound_of("(" + wave + " (/ (* rate " + std::to_string(cycles) + ") 8192))", samples);
  double strongest = 0.0;
  for (int n = samples / (2 * cycles) + 1; n * cycles < 2 * samples; ++n) {
    const int folded = std::abs((n * cycles + samples / 2) % samples - samples / 2);
    if (4 * folded < samples) {
      strongest = std::max(strongest, std::abs(line(sound, folded / static_cast<double>(samples))));
    }
  }
  return 20.0 * std::log10(strongest / std::abs(line(sound, cycles / static_cast<double>(samples))));
}

}  // namespace

ON_RANKS(1);

TEST(Oscillators, HaveTheSeriesOfFourier) {
  constexpr double frequency = 41.0 / 8192.0;
  const std::string argument = "(/ (* rate 41) 8192)";
  const auto sawtooth = sound_of("(sawtooth " + argument + ")", 8192);
  const auto square = sound_of("(square " + argument + ")", 8192);
  const auto triangle = sound_of("(triangle " + argument + ")", 8192);
  for (int n = 1; n < 50; ++n) {
    const double angle = std::numbers::pi * n * frequency;
    const double spline = std::pow(std::sin(angle) / angle, 4);  // transform of the cubic B-spline
    EXPECT_NEAR(std::abs(line(sawtooth, n * frequency)), spline * 2.0 / (std::numbers::pi * n), 1e-4);
    const double odd = n % 2 == 1 ? spline : 0.0;
    EXPECT_NEAR(std::abs(line(square, n * frequency)), odd * 4.0 / (std::numbers::pi * n), 1e-4);
    EXPECT_NEAR(std::abs(line(triangle, n * frequency)), odd * 8.0 / (std::numbers::pi * std::numbers::pi * n * n),
                1e-4);
  }
}

TEST(Oscillators, HaveNoAudibleAliases) {
  for (const int cycles : {41, 185, 409}) {
    for (const char* wave : {"sawtooth", "square", "triangle"}) {
      EXPECT_LT(strongest_alias(wave, cycles), -60.0) << wave << " " << cycles;
    }
  }
  EXPECT_EQ(mean_square(sound_of("(+ (sine rate) (sawtooth (* 0.6 rate)))", 100)), 0.0);
}

TEST(Oscillators, TurnRoundAtNegativeFrequencies) {
  for (const char* wave : {"sine", "sawtooth"}) {
    EXPECT_LT(mean_square(sound_of(fmt::format("(+ ({0} 441) ({0} -441))", wave), 2000)), 1e-20) << wave;
  }
  EXPECT_LT(mean_square(sound_of("(- (triangle 441) (triangle -441))", 2000)), 1e-20);
}

TEST(Oscillators, HaveADutyFromZeroToOne) {
  EXPECT_EQ(mistakes_of("(square 100 1.5)"), "t.tt:1:1: a duty is a number from 0 to 1, not 1.5");
  EXPECT_THROW(static_cast<void>(sound_of("(square 100 (+ 1 time))", 10)), std::runtime_error);
  EXPECT_NEAR(mean(sound_of("(square 100 1)", 10)), 1.0, 1e-12);
}

TEST(Oscillators, SteadyAndVaryingSinesAgree) {
  const auto steady = sound_of("(sine 1234.5 0.1)", 100000);
  const auto varying = sound_of("(sine (+ 1234.5 (* 0 time)) 0.1)", 100000);
  for (std::size_t i = 0; i < steady.size(); i += 99) {
    ASSERT_NEAR(steady[i], std::sin(2.0 * std::numbers::pi * (1234.5 * static_cast<double>(i) / 44100.0 + 0.1)), 1e-8);
    ASSERT_NEAR(varying[i], steady[i], 1e-8);
  }
}

}  // namespace idiophone::timbre
