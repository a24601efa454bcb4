#include "idiophone/listening/splat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace idiophone::listening {
namespace {

TEST(Splat, PassesAConstantAndKeepsTheArrivalExactly) {
  for (int i = 0; i < 1000; ++i) {
    const double arrival = 100.0 + 0.001 * i;
    const auto taps = Splat::instance().taps(arrival);
    double sum = 0.0, centroid = 0.0;
    for (std::size_t tap = 0; tap < lane_count; ++tap) {
      sum += taps.weights[tap];
      centroid += taps.weights[tap] * static_cast<double>(taps.before - 1 + static_cast<int>(tap));
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(centroid, arrival, 1e-11);
  }
}

TEST(Splat, IsItsFormulaToTwoBillionths) {
  for (int i = 0; i < 3000; ++i) {
    const double fraction = i / 3001.0;
    const auto taps = Splat::instance().taps(7.0 + fraction);
    const auto exact = Splat::exact(fraction);
    EXPECT_EQ(taps.before, 7);
    for (std::size_t tap = 0; tap < lane_count; ++tap) {
      EXPECT_NEAR(taps.weights[tap], exact[tap], 2e-9) << fraction;
    }
  }
}

TEST(Splat, IsAGaussianOfHalfASample) {
  for (int i = 0; i < 100; ++i) {
    const double fraction = 0.01 * i;
    const auto exact = Splat::exact(fraction);
    for (std::size_t tap = 0; tap < lane_count; ++tap) {
      const double offset = static_cast<double>(tap) - 1.0 - fraction;
      const double gaussian = std::exp(-2.0 * offset * offset) / std::sqrt(std::acos(-1.0) / 2.0);
      EXPECT_NEAR(exact[tap], gaussian, 0.03);
    }
  }
}

/// What is left of a sine on average over the fractions of a sample that it may arrive at.
double mean_response(double cycles_per_sample) {
  std::complex<double> sum = 0.0;
  constexpr int fractions = 1000;
  for (int i = 0; i < fractions; ++i) {
    const double fraction = (i + 0.5) / fractions;
    const auto weights = Splat::exact(fraction);
    for (std::size_t tap = 0; tap < lane_count; ++tap) {
      const double offset = static_cast<double>(tap) - 1.0 - fraction;
      sum += weights[tap] * std::exp(std::complex(0.0, 2.0 * std::numbers::pi * cycles_per_sample * offset)) /
             static_cast<double>(fractions);
    }
  }
  EXPECT_NEAR(sum.imag(), 0.0, 1e-12);
  return 20.0 * std::log10(sum.real());
}

TEST(Splat, LosesWhatAGaussianOfHalfASampleLoses) {
  for (const double kilohertz : {1.0, 5.0, 10.0, 15.0, 20.0}) {
    const double cycles = kilohertz / 44.1;
    const double gaussian = -20.0 * std::log10(std::exp(1.0)) * 0.5 * std::pow(std::numbers::pi * cycles, 2);
    EXPECT_NEAR(mean_response(cycles) / gaussian, 1.0, 0.03) << kilohertz;  // -0.55 dB at 5 kHz, -2.2 at 10 kHz
  }
}

}  // namespace
}  // namespace idiophone::listening
