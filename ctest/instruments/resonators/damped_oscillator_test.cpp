#include "idiophone/instruments/resonators/damped_oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rate.hpp"

namespace idiophone::resonators {

namespace {

TEST(DampedOscillator, StepsAsTheEquationOfMotion) {
  // z' = x z + a + b t has the solution z = (z0 + a/x + b/x^2) exp(x t) - a/x - b/x^2 - b t/x.
  const DampedOscillator oscillator(300.0, 200.0);
  EXPECT_NEAR(std::hypot(oscillator.damped, oscillator.decay), 2.0 * std::numbers::pi * 300.0, 1e-9);
  const Complex x = oscillator.exponent(), z(0.3, -0.2);
  const double a = 5.0, b = 1000.0, t = 2e-3;
  const Complex exact = (z + a / x + b / (x * x)) * std::exp(x * t) - a / x - b / (x * x) - b * t / x;
  const OscillatorStep step = oscillator.step(t);
  EXPECT_LT(std::abs(step.turn * z + step.first * a + step.last * (a + b * t) - exact), 1e-12);
}

TEST(DampedOscillator, TakesTheSameStepByMeanAndSlope) {
  for (const double frequency : {20.0, 440.0, 18000.0}) {  // both forms of the integrals
    const DampedOscillator oscillator(frequency, 50.0);
    const OscillatorStep step = oscillator.step(1.0 / rate);
    const Resonator resonator(oscillator, rate);
    const double begin = 2.0, end = -3.0;  // N
    const Complex expected = step.first * begin + step.last * end;
    const Complex found = resonator.by_mean * (0.5 * (begin + end)) + resonator.by_slope * (0.5 * (end - begin));
    EXPECT_LT(std::abs(found - expected), 1e-8 * std::abs(expected)) << frequency;
    EXPECT_LT(std::abs(resonator.turn - step.turn), 1e-15);
  }
}

TEST(DampedOscillator, DoesNotOscillateAboveTheCriticalDamping) {
  EXPECT_TRUE(DampedOscillator(100.0, 628.0).oscillates());
  EXPECT_FALSE(DampedOscillator(100.0, 629.0).oscillates());
}

}  // namespace

}  // namespace idiophone::resonators
