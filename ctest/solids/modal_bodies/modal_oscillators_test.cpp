#include "modal_oscillators.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace idiophone::modal_bodies {
namespace {

struct Oscillator {
  double frequency;
  double decay;
  double step;
  double place;
  double rate;

  /// @param target  w^2 times it is the force
  void advance(int n, double target) {
    const OscillatorStep exact(frequency, decay, step);
    rate = n == 0 ? first_rate(frequency, decay, step, place, rate, target)
                  : exact.keep * rate + exact.pull * (target - place);
    place += step * rate;
  }
};

TEST(Oscillators, FreeDecayIsExactForLongSteps) {
  for (const double angle : {1e-3, 0.1, 1.0, 2.5}) {  // of a step
    const double w = 5000;
    const double decay = 40;
    const double damped = std::sqrt(w * w - decay * decay);
    Oscillator body{w, decay, angle / w, 0.3, 20.0};
    for (int n = 0; n < 2000; ++n) {
      body.advance(n, 0.0);
    }
    const double t = 2000 * angle / w;
    const double exact =
        std::exp(-decay * t) * (0.3 * std::cos(damped * t) + (20 + decay * 0.3) / damped * std::sin(damped * t));
    EXPECT_NEAR(body.place, exact, 1e-10) << angle;
  }
}

TEST(Oscillators, ConstantForceIsExact) {
  for (const double decay : {0.0, 300.0, 5000.0, 9000.0}) {  // up to overdamped
    const double w = 5000;
    Oscillator once{w, decay, 4e-3, 0.0, 0.0};
    once.advance(0, 1.0);
    Oscillator often{w, decay, 1e-5, 0.0, 0.0};
    for (int n = 0; n < 400; ++n) {
      often.advance(n, 1.0);
    }
    EXPECT_NEAR(often.place, once.place, 1e-10) << decay;
  }
}

TEST(Oscillators, ChangeOfTheStepIsExact) {
  const double w = 5000;
  const double decay = 200;
  const double target = 0.1;
  const double damped = std::sqrt(w * w - decay * decay);
  double place = 0.3;
  double rate = 20.0;
  double before = 0.0;
  double t = 0.0;
  for (const double angle : {0.01, 1.5, 0.3, 2.5, 1e-4, 0.1}) {  // of each step
    rate = rate_of_other_step(w, decay, {before, angle / w}, place, rate, target);
    before = angle / w;
    place += before * rate;
    t += before;
    const double exact = target + std::exp(-decay * t) *
                                      (0.2 * std::cos(damped * t) + (20 + decay * 0.2) / damped * std::sin(damped * t));
    EXPECT_NEAR(place, exact, 1e-11) << angle;
  }
}

TEST(Oscillators, SpringBesideAnotherNeitherGainsNorLosesEnergy) {
  // A second spring that acts as a force on the oscillator; it makes it sqrt(2) times as fast.
  const double w = 1000;
  Oscillator body{w, 0.0, 1e-4, 1.0, 0.0};
  double largest = 0.0;
  for (int n = 0; n < 100000; ++n) {
    body.advance(n, -body.place);
    largest = n > 90000 ? std::max(largest, std::abs(body.place)) : 0.0;
  }
  EXPECT_NEAR(largest, 1.0, 2e-3);
}

TEST(Oscillators, RateInTheMiddleIsExactForFreeVibrations) {
  const double w = 2000;
  const double step = 3e-4;
  Oscillator body{w, 0.0, step, 1.0, 0.0};
  double before = 0.0;
  for (int n = 0; n < 10; ++n) {
    before = body.rate;
    body.advance(n, 0.0);
  }
  EXPECT_NEAR((before + body.rate) / 2 * rate_correction(w, step), -w * std::sin(w * 9 * step), 1e-9 * w);
}

}  // namespace
}  // namespace idiophone::modal_bodies
