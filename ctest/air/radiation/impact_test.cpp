// Two balls that collide: the sound of two rigid spheres that accelerate (Koss and Alfredson 1973).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vibrating_solid.hpp"

namespace idiophone::radiation {
namespace {

using std::numbers::pi;
constexpr double ball_radius = 0.02;  // m
constexpr double contact = 150e-6;    // s; c contact/a = 2.6
constexpr double speed = 1.0;         // that each ball gains, m/s

/// Velocity of the ball that is pushed along z, from rest, by a half-sine of force.
double pushed(double time) {
  const double phase = pi * std::clamp(time / contact, 0.0, 1.0);
  return speed * (1.0 - std::cos(phase)) / 2.0;
}

/// Pressure of one rigid sphere. Its velocity's step 1 sends, with x = r/a and T = (t - (r - a)/c) c/a,
/// p = z cos(theta)/x exp(-T) [cos T + (1/x - 1) sin T]: l = 1, from z s (s + 1/x)/(x (s^2 + 2 s + 2)) over s. An
/// acceleration is a sequence of steps.
double exact(const Vector3& from_centre, double time) {
  constexpr int steps = 400;
  const double x = from_centre.norm() / ball_radius;
  const double cosine = from_centre.normalized().z();
  const double left = time - (from_centre.norm() - ball_radius) / test_air.speed;
  double pressure = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double begin = contact * i / steps;
    const double passed = (left - begin - 0.5 * contact / steps) * test_air.speed / ball_radius;
    if (passed > 0.0) {
      pressure += (pushed(begin + contact / steps) - pushed(begin)) * std::exp(-passed) *
                  (std::cos(passed) + (1.0 / x - 1.0) * std::sin(passed));
    }
  }
  return air_density * test_air.speed * cosine / x * pressure;
}

struct Comparison {
  double level;        ///< of the largest pressure, above the exact one, dB
  double correlation;  ///< of the two pulses
};

/// The upper ball is pushed upwards, the lower one downwards.
Comparison compare(std::optional<Field> field, const Vector3& receiver) {
  constexpr int samples = 200;
  const Solid ball = sphere(ball_radius, 12);
  const Vector3 up(0, 0, ball_radius);
  const auto hear = [&](double sign) {
    return listen(
        ball, [&](const Vector3&, const Vector3& normal, double time) { return sign * normal.z() * pushed(time); },
        kirchhoff, field, receiver - sign * up, samples);
  };
  const auto upper = hear(1.0), lower = hear(-1.0);
  double product = 0.0, heard_square = 0.0, exact_square = 0.0, heard_peak = 0.0, exact_peak = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double time = static_cast<double>(i) / test_air.rate;
    const double sound = upper[i] + lower[i];
    const double right = exact(receiver - up, time) - exact(receiver + up, time);
    product += sound * right;
    heard_square += sound * sound;
    exact_square += right * right;
    heard_peak = std::max(heard_peak, std::abs(sound));
    exact_peak = std::max(exact_peak, std::abs(right));
  }
  return {decibels(heard_peak, exact_peak), product / std::sqrt(heard_square * exact_square)};
}

TEST(CollidingBalls, AreHeardAsRigidSpheres) {
  for (const Vector3& receiver : {Vector3(0, 0, 0.5), Vector3(0.4, 0, 0), Vector3(0.3, 0.1, 0.3)}) {
    const Comparison heard = compare(Field::oscillating, receiver);
    EXPECT_NEAR(heard.level, 0.0, 0.15);
    EXPECT_GT(heard.correlation, 0.9995);
  }
}

TEST(CollidingBalls, AreHeardLessWellByOtherSurfacePressures) {
  const Vector3 across(0.4, 0, 0);
  EXPECT_NEAR(compare(Field::pulsating, across).level, 0.5, 0.1);
  EXPECT_NEAR(compare(Field::pulsating, across).correlation, 0.987, 0.003);
  EXPECT_NEAR(compare({}, across).level, 2.8, 0.2);
  EXPECT_NEAR(compare({}, across).correlation, 0.67, 0.02);
}

}  // namespace
}  // namespace idiophone::radiation
