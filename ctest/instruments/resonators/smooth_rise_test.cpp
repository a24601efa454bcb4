#include "idiophone/instruments/resonators/smooth_rise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/force.hpp"
#include "idiophone/instruments/resonators/resonator_bank.hpp"
#include "rate.hpp"

namespace idiophone::resonators {

namespace {

/// The sound of a force on one mode of 1000 Hz, whose pressure is neither in phase with its velocity nor across.
std::vector<double> sound_of(ForceCurve force) {
  const DampedOscillator oscillator(1000.0, 50.0);
  const Resonator resonator(oscillator, rate);
  add_rise(force, oscillator.damped, rate);
  ResonatorBank bank({{resonator.turn}});
  const auto gains = in_groups({{Complex(0.6, -0.8) * resonator.velocity}});
  const auto by_mean = in_groups({{resonator.by_mean}}), by_slope = in_groups({{resonator.by_slope}});
  std::vector<double> sound(force.size());
  for (std::size_t first = 0; first < sound.size(); first += ResonatorBank::most_samples) {
    const std::size_t count = std::min(ResonatorBank::most_samples, sound.size() - first);
    const Drive drive{.force = std::span(force).subspan(first, count), .by_mean = by_mean, .by_slope = by_slope};
    bank.advance({&drive, 1}, gains, 1, std::span(sound).subspan(first, count));
  }
  return sound;
}

double largest(std::span<const double> sound) {
  double most = 0.0;
  for (const double sample : sound) {
    most = std::max(most, std::abs(sample));
  }
  return most;
}

/// Of a force whose frequency rises slowly from zero, so that the mode does not ring.
double level_at(double frequency) {
  const double duration = 1.0;
  const auto force = [&](double time) {
    return std::pow(std::sin(std::numbers::pi * time / duration), 2) *
           std::sin(2.0 * std::numbers::pi * frequency * time);
  };
  const std::vector<double> sound = sound_of(sampled(force, duration, rate));
  return largest(std::span(sound).subspan(rate / 4, rate / 2));
}

}  // namespace

TEST(SmoothRise, IsExactForAForceThatRisesEvenly) {
  const double angular = 3000.0, newtons_per_second = 7.0, step = 1e-4;
  SmoothRise rise(angular, step);
  for (int i = 0; i < 30; ++i) {
    const double time = i * step;
    EXPECT_NEAR(rise.at(newtons_per_second * time), newtons_per_second * (1.0 - std::exp(-angular * time)), 1e-9);
    rise.advance(newtons_per_second * time, newtons_per_second * (time + step));
  }
}

TEST(SmoothRise, IsFollowedUntilItIsNegligible) {
  ForceCurve force = sampled([](double) { return 2.0; }, 0.01, rate);
  const std::size_t samples = force.size();
  add_rise(force, 5000.0, rate);
  ASSERT_GT(force.size(), samples);
  EXPECT_NEAR(force.front().rise, 2.0 * 5000.0 / rate, 1e-9) << "it begins at once";
  EXPECT_NEAR(force[samples].rise, -2.0 * 5000.0 / rate, 1e-9) << "and ends at once";
  EXPECT_LT(std::abs(force.back().rise), 1e-4 * force.front().rise);
}

TEST(SmoothRise, LeavesAConstantForceSilent) {
  const std::vector<double> sound = sound_of(sampled([](double) { return 1.0; }, 1.0, rate));
  EXPECT_GT(largest(std::span(sound).first(100)), 1e-5);
  EXPECT_LT(largest(std::span(sound).subspan(rate / 2, rate / 4)), 1e-10 * largest(sound));
}

TEST(SmoothRise, LetsTheSoundFallBy12DecibelsAnOctaveBelowTheMode) {
  const double at_ten = level_at(10.0);
  EXPECT_NEAR(20.0 * std::log10(level_at(20.0) / at_ten), 12.0, 0.5);
  EXPECT_NEAR(20.0 * std::log10(level_at(40.0) / at_ten), 24.0, 0.5);
}

}  // namespace idiophone::resonators
