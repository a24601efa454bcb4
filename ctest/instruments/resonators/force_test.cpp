#include "idiophone/instruments/resonators/force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "idiophone/instruments/resonators/resonator_bank.hpp"
#include "rate.hpp"

namespace idiophone::resonators {

namespace {

using std::numbers::pi;

/// The contact of a hammer with a body that does not give way, by Runge and Kutta.
struct ExactContact {
  double duration = 0.0, peak = 0.0;
  std::vector<double> force;  // N, at multiples of `step`
  double step = 0.0;          // s

  explicit ExactContact(const score::Hammer& hammer) {
    const auto law = [&](double approach) { return hammer.hardness * std::pow(std::max(approach, 0.0), 1.5); };
    step = HertzPulse(hammer).duration / 20000.0;
    double x = 0.0, v = hammer.speed;
    for (; x >= 0.0; duration += step) {
      force.push_back(law(x));
      peak = std::max(peak, force.back());
      const auto slope = [&](double place) { return -law(place) / hammer.mass; };
      const double k1 = slope(x), k2 = slope(x + 0.5 * step * v), k3 = slope(x + 0.5 * step * (v + 0.5 * step * k1)),
                   k4 = slope(x + step * (v + 0.5 * step * k2));
      x += step * (v + step / 6.0 * (k1 + k2 + k3));
      v += step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
  }

  [[nodiscard]] double spectrum(double frequency) const {
    Complex sum = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      sum += step * force[i] * std::polar(1.0, -2.0 * pi * frequency * static_cast<double>(i) * step);
    }
    return std::abs(sum);
  }
};

/// What a mode of a frequency without damping gets from a force: z/phi after it is over, by the bank's recurrence.
Complex response(const ForceCurve& force, double frequency) {
  const Resonator mode({frequency, 0.0}, rate);
  Complex z = 0.0;
  for (const ForcePiece& piece : force) {
    z = mode.turn * z + mode.by_mean * piece.mean + mode.by_slope * piece.slope;
  }
  return z;
}

score::Stroke some_stroke() {
  score::Stroke stroke;
  stroke.to = {0.5, 0.0, 0.0};
  stroke.speed = 0.5;
  stroke.load = 2.0;
  stroke.mass = 0.05;
  stroke.hardness = 1e9;
  stroke.size = 0.0;
  stroke.roughness = {.height = 1e-9, .exponent = 0.0, .longest = 1e-3, .shortest = 1e-4};
  return stroke;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Root of the mean square about the load, in the middle of a stroke.
double fluctuation(const std::vector<double>& force, double load) {
  double sum = 0.0;
  const std::size_t margin = rate / 50;
  for (std::size_t i = margin; i + margin < force.size(); ++i) {
    sum += std::pow(force[i] - load, 2);
  }
  return std::sqrt(sum / static_cast<double>(force.size() - 2 * margin));
}

}  // namespace

TEST(HertzPulse, HasTheDurationImpulseAndSpectrumOfTheContact) {
  for (const score::Hammer& hammer : {score::Hammer{0.02, 1e8, 1.0}, score::Hammer{0.5, 3e6, 3.0}}) {
    const HertzPulse pulse(hammer);
    const ExactContact exact(hammer);
    EXPECT_NEAR(pulse.duration / exact.duration, 1.0, 1e-3);
    EXPECT_NEAR(pulse.peak / exact.peak, 1.0, 0.03);
    const auto force = [&](double time) { return pulse.at(time); };
    for (const double periods : {0.01, 0.3, 0.6, 1.0}) {  // up to the first zero of the spectrum at about 1.7
      const double frequency = periods / pulse.duration;
      const double found = std::abs(response(sampled(force, pulse.duration, rate), frequency));
      EXPECT_NEAR(20.0 * std::log10(found / exact.spectrum(frequency)), 0.0, 0.5) << periods;
    }
    EXPECT_NEAR(exact.spectrum(0.0) / (2.0 * hammer.mass * hammer.speed), 1.0, 1e-3);
    EXPECT_NEAR(std::abs(response(sampled(force, pulse.duration, rate), 1e-3)) / (2.0 * hammer.mass * hammer.speed),
                1.0, 1e-3);
  }
}

TEST(HertzPulse, IsShorterAndStrongerForHarderAndFasterHammers) {
  const HertzPulse soft({0.02, 1e8, 1.0}), hard({0.02, 3.2e9, 1.0}), fast({0.02, 1e8, 32.0});
  EXPECT_NEAR(soft.duration / hard.duration, 4.0, 1e-9);  // hardness^(-2/5)
  EXPECT_NEAR(soft.duration / fast.duration, 2.0, 1e-9);  // speed^(-1/5)
  EXPECT_NEAR(fast.peak / soft.peak, 64.0, 1e-9);         // speed^(6/5)
}

TEST(SampledForce, DrivesModesAsTheForceItself) {
  // A half sine of amplitude 1: the integral of sin(pi t/T) exp(-i w t) is 2 pi T/(pi^2 - w^2 T^2) cos(w T/2) in size.
  for (const double duration : {4e-4, 1.03e-3}) {
    const ForceCurve force = sampled([&](double time) { return std::sin(pi * time / duration); }, duration, rate);
    for (const double frequency : {100.0, 800.0, 3000.0, 9000.0, 16000.0}) {
      const double w = 2.0 * pi * frequency * duration;
      const double exact = std::abs(2.0 * pi * duration / (pi * pi - w * w) * std::cos(0.5 * w));
      const double envelope = std::abs(2.0 * pi * duration / (pi * pi - w * w));  // without the zeros
      EXPECT_NEAR(std::abs(response(force, frequency)), exact, 0.006 * envelope) << duration << " " << frequency;
    }
  }
}

TEST(SampledForce, IsExactWhereTheForceIsLinear) {
  const ForceCurve force = sampled([](double time) { return 3.0 + 1e4 * time; }, 2.0 / rate, rate);
  ASSERT_EQ(force.size(), 2U);
  EXPECT_NEAR(force[1].mean, 3.0 + 1e4 * 1.5 / rate, 1e-12);
  EXPECT_NEAR(force[1].slope, 0.5e4 / rate, 1e-12);
}

TEST(SampledForce, HasTheImpulseOfForcesMuchShorterThanASample) {
  for (const double duration : {1e-9, 3e-6, 2.5e-5}) {
    const ForceCurve force = sampled([&](double time) { return std::sin(pi * time / duration); }, duration, rate);
    EXPECT_NEAR(std::abs(response(force, 1.0)) / (2.0 * duration / pi), 1.0, 1e-6);
  }
}

TEST(StrokeForce, PressesOnAverageWithTheLoad) {
  EXPECT_NEAR(mean_of(stroke_force(some_stroke(), 1, rate)), 2.0 * (1.0 - 0.01), 1e-3);  // ramps of 10 ms at both ends
}

TEST(StrokeForce, IsTheContactsSpringAboveItsFrequency) {
  score::Stroke stroke = some_stroke();  // waves of 500 Hz to 5 kHz
  stroke.mass = 1e4;                     // does not move
  const double approach = std::pow(stroke.load / stroke.hardness, 2.0 / 3.0);
  const double spring = 1.5 * stroke.hardness * std::sqrt(approach);
  EXPECT_NEAR(fluctuation(stroke_force(stroke, 1, rate), stroke.load) / (spring * stroke.roughness.height), 1.0, 0.1);
}

TEST(StrokeForce, AcceleratesTheToolBelowTheContactsFrequency) {
  score::Stroke stroke = some_stroke();
  stroke.mass = 1e-4;
  stroke.hardness = 1e13;
  stroke.roughness.longest = 5.02e-4;  // 1 kHz at 0.5 m/s
  stroke.roughness.shortest = 4.98e-4;
  const double w = 2.0 * pi * 1000.0;
  const double expected = stroke.mass * w * w * stroke.roughness.height;
  EXPECT_NEAR(fluctuation(stroke_force(stroke, 1, rate), stroke.load) / expected, 1.0, 0.1);
}

TEST(StrokeForce, IsSmootherForLargerContacts) {
  score::Stroke stroke = some_stroke();
  const double small = fluctuation(stroke_force(stroke, 1, rate), stroke.load);
  stroke.size = 1e-3;
  EXPECT_LT(fluctuation(stroke_force(stroke, 1, rate), stroke.load), 0.3 * small);
}

TEST(StrokeForce, NeverPulls) {
  score::Stroke stroke = some_stroke();
  stroke.roughness.height = 1e-4;
  const std::vector<double> force = stroke_force(stroke, 1, rate);
  EXPECT_EQ(*std::ranges::min_element(force), 0.0);
}

TEST(StrokeForce, DependsOnTheSeedAlone) {
  EXPECT_EQ(stroke_force(some_stroke(), 5, rate), stroke_force(some_stroke(), 5, rate));
  EXPECT_NE(stroke_force(some_stroke(), 5, rate), stroke_force(some_stroke(), 6, rate));
}

}  // namespace idiophone::resonators
