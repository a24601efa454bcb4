#include "idiophone/listening/spreading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace idiophone::listening {
namespace {

constexpr double pi = std::numbers::pi;

/// All weights of an arrival at `before` + fraction.
std::vector<double> weights(const Spreading& spreading, double fraction, bool change = false) {
  const Spreading::ArrivalCell place = Spreading::cell_of(7.0 + fraction);
  EXPECT_EQ(place.before, 7);
  std::vector<double> all;
  for (std::size_t group = 0; group < spreading.width() / lane_count; ++group) {
    const Lanes4 lanes = change ? spreading.change(place, group) : spreading.sound(place, group);
    all.insert(all.end(), {lanes[0], lanes[1], lanes[2], lanes[3]});
  }
  return all;
}

/// What the weights make of exp(i w n) that arrives at 0: exp(0) = 1, or i w, is perfect.
std::complex<double> response(const std::vector<double>& weights, double fraction, double w) {
  std::complex<double> sum = 0.0;
  const double first = 1.0 - static_cast<double>(weights.size() / 2) - fraction;
  for (std::size_t tap = 0; tap < weights.size(); ++tap) {
    sum += weights[tap] * std::exp(std::complex(0.0, -w * (first + static_cast<double>(tap))));
  }
  return sum;
}

double decibels(std::complex<double> ratio) {
  return 20.0 * std::log10(std::abs(ratio));
}

TEST(Spreading, PassesConstantsAndRampsExactly) {
  for (const auto* spreading : {&Spreading::splat(), &Spreading::band_limited()}) {
    for (int i = 0; i < 1000; ++i) {
      const double fraction = 0.001 * i;
      const auto sound = weights(*spreading, fraction);
      EXPECT_NEAR(std::abs(response(sound, fraction, 0.0)), 1.0, 1e-13);
      EXPECT_NEAR(response(sound, fraction, 1e-6).imag() / 1e-6, 0.0, 1e-8);  // the centroid is the arrival
      if (spreading->differentiates()) {
        const auto change = weights(*spreading, fraction, true);
        EXPECT_NEAR(std::abs(response(change, fraction, 0.0)), 0.0, 1e-12);
        EXPECT_NEAR(response(change, fraction, 1e-6).imag() / 1e-6, 1.0, 1e-6);
      }
    }
  }
}

TEST(Spreading, IsItsFormula) {
  for (int i = 0; i < 300; ++i) {
    const double fraction = i / 301.0;
    const auto compare = [&](const std::vector<double>& tabulated, const std::vector<double>& exact, double tolerance) {
      ASSERT_EQ(tabulated.size(), exact.size());
      for (std::size_t tap = 0; tap < exact.size(); ++tap) {
        EXPECT_NEAR(tabulated[tap], exact[tap], tolerance) << fraction;
      }
    };
    compare(weights(Spreading::splat(), fraction), gaussian_splat(fraction), 2e-9);
    compare(weights(Spreading::band_limited(), fraction), least_squares_spreading(fraction, 12, 0), 1e-8);
    compare(weights(Spreading::band_limited(), fraction, true), least_squares_spreading(fraction, 12, 1), 1e-8);
  }
}

TEST(Splat, IsAGaussianOfHalfASample) {
  for (int i = 0; i < 100; ++i) {
    const double fraction = 0.01 * i;
    const auto exact = gaussian_splat(fraction);
    for (std::size_t tap = 0; tap < exact.size(); ++tap) {
      const double offset = static_cast<double>(tap) - 1.0 - fraction;
      EXPECT_NEAR(exact[tap], std::exp(-2.0 * offset * offset) / std::sqrt(pi / 2.0), 0.03);
    }
  }
}

TEST(Splat, LosesWhatAGaussianOfHalfASampleLoses) {
  for (const double kilohertz : {1.0, 5.0, 10.0, 15.0, 20.0}) {
    const double cycles = kilohertz / 44.1;
    constexpr int fractions = 1000;
    std::complex<double> mean = 0.0;
    for (int i = 0; i < fractions; ++i) {
      const double fraction = (i + 0.5) / fractions;
      mean += response(gaussian_splat(fraction), fraction, 2.0 * pi * cycles) / static_cast<double>(fractions);
    }
    EXPECT_NEAR(mean.imag(), 0.0, 1e-12);
    const double gaussian = -20.0 * std::log10(std::exp(1.0)) * 0.5 * std::pow(pi * cycles, 2);
    EXPECT_NEAR(decibels(mean) / gaussian, 1.0, 0.03) << kilohertz;  // -0.55 dB at 5 kHz, -2.2 at 10 kHz
  }
}

TEST(BandLimited, DelaysAndDifferentiatesUpToFourTenthsOfTheRate) {
  const auto& spreading = Spreading::band_limited();
  EXPECT_EQ(spreading.width(), 12);
  EXPECT_EQ(spreading.first(), -5);
  for (int i = 0; i < 50; ++i) {
    const double fraction = 0.02 * i;
    for (double cycles = 0.005; cycles < 0.39; cycles += 0.005) {
      const double w = 2.0 * pi * cycles;
      const auto delayed = response(weights(spreading, fraction), fraction, w);
      const auto differentiated = response(weights(spreading, fraction, true), fraction, w) / std::complex(0.0, w);
      constexpr double tolerance = 0.13;
      EXPECT_NEAR(decibels(delayed), 0.0, tolerance) << cycles;
      EXPECT_NEAR(decibels(differentiated), 0.0, tolerance) << cycles;
      EXPECT_NEAR(std::arg(delayed), 0.0, 0.04);
      EXPECT_NEAR(std::arg(differentiated), 0.0, 0.04);
    }
  }
}

}  // namespace
}  // namespace idiophone::listening
