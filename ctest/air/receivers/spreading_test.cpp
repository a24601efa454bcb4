#include "idiophone/air/receivers/spreading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "idiophone/air/receivers/filter_bank.hpp"
#include "ranks.hpp"

namespace idiophone::receivers {
namespace {

using std::numbers::pi;

/// All weights of an arrival at `before` + fraction, those of a sound times one number and of a change times another.
std::vector<double> sums(const Spreading& spreading, double fraction, double sound, double change) {
  const Lanes4 ones = Lanes4{} + 1.0;
  const Spreading::ArrivalCells places(Lanes4{7.0, 7.0 + fraction, 8.0, 9.0});  // in entries
  EXPECT_EQ(places.before[1], 7);
  const auto factors = spreading.weights().factors(places, sound * ones, change * ones);
  std::vector<double> all;
  for (std::size_t group = 0; group < spreading.width() / lane_count; ++group) {
    const Lanes4 lanes = spreading.weights().sum(places[1], group, factors, 1);
    all.insert(all.end(), {lanes[0], lanes[1], lanes[2], lanes[3]});
  }
  return all;
}

/// All weights of a sound's arrival at `before` + fraction, or of a change's.
std::vector<double> weights(const Spreading& spreading, double fraction, bool change = false) {
  if (change) {
    return sums(spreading, fraction, 0.0, 1.0);
  }
  const Spreading::ArrivalCell place = Spreading::cell_of(7.0 + fraction);  // in entries
  EXPECT_EQ(place.before, 7);
  std::vector<double> all;
  for (std::size_t group = 0; group < spreading.width() / lane_count; ++group) {
    const Lanes4 lanes = spreading.weights().sound(place, group);
    all.insert(all.end(), {lanes[0], lanes[1], lanes[2], lanes[3]});
  }
  return all;
}

/// What the weights make of exp(i w n) that arrives at 0: exp(0) = 1, or i w, is perfect.
std::complex<double> response(const std::vector<double>& weights, double fraction, double w) {
  std::complex<double> sum = 0.0;
  const double first = 1.0 - 0.5 * static_cast<double>(weights.size()) - fraction;
  for (std::size_t tap = 0; tap < weights.size(); ++tap) {
    sum += weights[tap] * std::exp(std::complex(0.0, -w * (first + static_cast<double>(tap))));
  }
  return sum;
}

double decibels(std::complex<double> ratio) {
  return 20.0 * std::log10(std::abs(ratio));
}

ON_RANKS(1);

TEST(Spreading, PassesConstantsAndRampsExactly) {
  for (const auto* spreading : {&Spreading::splat(), &Spreading::band_limited()}) {
    for (int i = 0; i < 1000; ++i) {
      const double fraction = 0.001 * i;
      const auto sound = weights(*spreading, fraction);
      EXPECT_NEAR(std::abs(response(sound, fraction, 0.0)), 1.0, 1e-13);
      EXPECT_NEAR(response(sound, fraction, 1e-6).imag() / 1e-6, 0.0, 1e-8);  // the centroid is the arrival
      if (spreading->differentiates()) {
        const auto change = weights(*spreading, fraction, true);
        EXPECT_NEAR(std::abs(response(change, fraction, 0.0)), 0.0, 1e-11);
        EXPECT_NEAR(response(change, fraction, 1e-6).imag() / 1e-6, static_cast<double>(spreading->density()), 1e-5);
      }
    }
  }
}

TEST(Spreading, AddsASoundAndItsChange) {
  const Spreading& spreading = Spreading::band_limited();
  for (const double fraction : {0.0, 0.003, 0.35, 0.999}) {
    const auto both = sums(spreading, fraction, 2.0, -3.0);
    constexpr double apart = 1e-6;
    const auto sound = weights(spreading, fraction), after = weights(spreading, fraction + apart);
    for (std::size_t tap = 0; tap < both.size(); ++tap) {
      const double change = -static_cast<double>(spreading.density()) * (after[tap] - sound[tap]) / apart;
      EXPECT_NEAR(both[tap], 2.0 * sound[tap] - 3.0 * change, 1e-4) << fraction;
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
    compare(weights(Spreading::band_limited(), fraction), kaiser_bessel_spreading(fraction), 1e-9);
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

TEST(BandLimited, HasFiltersThatKeepConstants) {
  const Spreading& spreading = Spreading::band_limited();
  EXPECT_EQ(spreading.width(), 8);
  EXPECT_EQ(spreading.density(), 2);
  EXPECT_EQ(spreading.first(), -2);
  EXPECT_EQ(spreading.lookahead(), 40);
  for (const auto& filter : spreading.entries_to_samples()) {
    EXPECT_NEAR(std::accumulate(filter.begin(), filter.end(), 0.0), 1.0, 1e-13);
  }
}

/// Largest difference between what is heard of a tone of amplitude 1, or of its derivative, and the exact sound. A
/// source that moves away at a speed (over that of sound) is heard with the frequency and the amplitude of its Doppler
/// shift.
double worst_error(double cycles, double speed, bool change) {
  constexpr std::int64_t samples = 4000;
  constexpr double first_delay = 700.3;
  const Spreading& spreading = Spreading::band_limited();
  FilterBank bank(spreading.first(), 1e4, spreading, Filters::none());
  const double w = 2.0 * pi * cycles;
  for (std::int64_t sample = 0; sample < samples; ++sample) {
    radiation::Arrivals arrivals{std::vector<double>(4), {}, std::vector<double>(4, first_delay)};
    arrivals.delay[1] = first_delay + speed * static_cast<double>(sample);
    (change ? arrivals.change : arrivals.sound).resize(4);
    (change ? arrivals.change : arrivals.sound)[1] = std::cos(w * static_cast<double>(sample));
    bank.add(0, sample, arrivals);
  }
  const std::int64_t begin = bank.first();
  const std::vector<double> heard = bank.take(static_cast<std::size_t>(3500 - begin), MPI_COMM_SELF).at(0);
  const double shift = 1.0 / (1.0 + speed);
  double worst = 0.0;
  for (std::int64_t n = 1500; n < 3500; ++n) {
    const double phase = w * shift * (static_cast<double>(n) - first_delay);
    const double exact = change ? -w * shift * std::sin(phase) : std::cos(phase);
    worst = std::max(worst, std::abs(heard[n - begin] / shift - exact));
  }
  return worst;
}

TEST(BandLimited, HearsMovingTonesWithoutFalsePartials) {
  for (const double speed : {0.0, 1e-4, 0.003, 0.0583, -0.0583}) {
    for (const double cycles : {0.002, 0.0227, 0.1, 0.2, 0.3, 0.4, 0.42, 0.45}) {
      if (std::abs(speed) < 0.01 || cycles <= 0.42) {  // 20 m/s
        EXPECT_LT(worst_error(cycles, speed, false), 1.2e-5) << cycles << " cycles a sample, " << speed;
        EXPECT_LT(worst_error(cycles, speed, true), 6e-6 + 3e-5 * 2.0 * pi * cycles)
            << cycles << " cycles a sample, derivative, " << speed;
      }
    }
  }
}

}  // namespace
}  // namespace idiophone::receivers
