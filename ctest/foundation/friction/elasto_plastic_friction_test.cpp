#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace idiophone::friction {

namespace {

constexpr double step = 1.0 / 48000;  // s

double slide(ElastoPlasticFriction& friction, double velocity, double load, int steps) {
  double force = 0.0;
  for (int i = 0; i < steps; ++i) {
    force = friction.force(velocity, load);
    friction.advance(velocity, load);
  }
  return force;
}

}  // namespace

TEST(ElastoPlasticFriction, SlidesWithTheForceOfTheStribeckCurve) {
  const Law law{.sticking = 0.9, .sliding = 0.2, .stribeck_speed = 0.05, .damping = 3.0, .viscosity = 0.1};
  for (const double velocity : {-0.5, -0.05, 0.01, 0.1, 2.0}) {
    ElastoPlasticFriction friction(law, step);
    const double coefficient = 0.2 + 0.7 * std::exp(-std::pow(velocity / 0.05, 2));
    EXPECT_NEAR(slide(friction, velocity, 2.0, 4000), std::copysign(2.0 * coefficient, velocity) + 0.1 * velocity,
                1e-12);
  }
}

TEST(ElastoPlasticFriction, IsASpringBelowTheBreakAwayDeflection) {
  const Law law{.sliding = 0.5, .stiffness = 1e4, .break_away = 0.8};
  ElastoPlasticFriction friction(law, step);
  const double velocity = 0.79 * 0.5 / 1e4 / (100 * step);
  EXPECT_NEAR(slide(friction, velocity, 1.0, 100), 0.79 * 0.5, 0.01);
  EXPECT_NEAR(friction.deflection(), 100 * step * velocity, 1e-18);
  slide(friction, -velocity, 1.0, 100);
  EXPECT_NEAR(friction.deflection(), 0.0, 1e-18);
}

TEST(ElastoPlasticFriction, NeverGivesMoreThanItWasGiven) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    const Law law{.sticking = 0.3 + any(random),
                  .sliding = 0.3 * any(random) + 0.001,
                  .stribeck_speed = std::pow(10.0, -3.0 * any(random)),
                  .stiffness = std::pow(10.0, 2.0 + 5.0 * any(random)),
                  .damping = 100.0 * any(random),
                  .break_away = 0.99 * any(random)};
    ElastoPlasticFriction friction(law, step);
    for (int i = 0; i < 100; ++i) {
      const double velocity = std::pow(any(random), 3.0) * (any(random) < 0.3 ? -10.0 : 1.0), load = 5.0 * any(random);
      const double before = friction.stored_energy();
      const double work = friction.force(velocity, load) * velocity * step;
      friction.advance(velocity, load);
      const double after = friction.stored_energy();
      ASSERT_GE(work + before - after, -1e-14 * (std::abs(work) + before + after)) << trial << " " << i;
    }
  }
}

TEST(ElastoPlasticFriction, ItsViscosityVanishesWithTheLoad) {
  const Law law{.sticking = 0.8, .sliding = 0.3, .stribeck_speed = 0.1, .viscosity = 0.1};
  for (const double load : {0.1, 0.05, 1e-3, 1e-9, 0.0}) {  // from 1/16 N on, it counts in full
    ElastoPlasticFriction friction(law, step, Deflection::end);
    EXPECT_NEAR(slide(friction, -0.5, load, 4000), -load * 0.3 - std::min(0.1 * 0.5, 0.8 * load), 1e-9 * load);
  }
}

TEST(ElastoPlasticFriction, AtTheEndOfAStepHasTheForceOfItsEnd) {
  const Law law{.sticking = 0.8, .sliding = 0.3, .stribeck_speed = 0.1, .stiffness = 1e6};
  ElastoPlasticFriction friction(law, step, Deflection::end);
  EXPECT_NEAR(slide(friction, 1e-4, 1.0, 50), law.stiffness * 50 * step * 1e-4, 1e-12);  // sticks: no half step late
  EXPECT_NEAR(friction.deflection(), 50 * step * 1e-4, 1e-18);
  slide(friction, 2.0, 1.0, 3);  // slides by 140 times the deflection in each step, and does not alternate
  EXPECT_NEAR(law.stiffness * friction.deflection(), 0.3, 0.003);
}

TEST(ElastoPlasticFriction, FindsTheVelocityThatTheForceLeaves) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (const double mobility : {0.0, 1e-3, 1.0, 1e3, 1e6}) {
    ElastoPlasticFriction friction({.damping = 1.0}, step);
    for (int i = 0; i < 1000; ++i) {
      const double free = any(random), load = 1.0 + any(random);
      const double velocity = friction.velocity(free, mobility, load);
      const double taken = mobility * friction.force(velocity, load);
      ASSERT_NEAR(velocity, free - taken, 1e-12 * (std::abs(free) + std::abs(taken))) << mobility << " " << i;
      friction.advance(velocity, load);
    }
  }
}

// At 0.6 m/s, both sticking and sliding with 0.3 m/s are possible: the friction is between 0.3 and 0.8 N.
TEST(ElastoPlasticFriction, WhatSticksGoesOnToStickAndWhatSlidesToSlide) {
  const Law law{.sticking = 0.8, .sliding = 0.3, .stribeck_speed = 0.1, .stiffness = 1e8};
  const auto velocity_after_ramp = [&](double from) {
    constexpr int steps = 1000;
    ElastoPlasticFriction friction(law, step);
    double velocity = 0.0;
    for (int i = 0; i <= steps; ++i) {
      velocity = friction.velocity(from + (0.6 - from) * i / steps, 1.0, 1.0);
      friction.advance(velocity, 1.0);
    }
    return velocity;
  };
  EXPECT_NEAR(velocity_after_ramp(0.0), 0.0, 0.1);
  EXPECT_NEAR(velocity_after_ramp(2.0), 0.3, 0.01);
}

}  // namespace idiophone::friction
