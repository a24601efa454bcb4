#include "bristles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

constexpr double step_of_bristles = 1e-5;  // s

friction::Law soft_bristles() {
  return {.sticking = 0.8, .sliding = 0.3, .stribeck_speed = 0.1, .stiffness = 2e4, .damping = 2.0, .viscosity = 0.1};
}

ON_RANKS(1);

TEST(Bristles, RubOnALineAsBowsDo) {
  const friction::Law law = soft_bristles();
  friction::ElastoPlasticFriction bow(law, step_of_bristles, friction::Deflection::end);
  const Vector3 line = Vector3(1, 2, -2) / 3;
  Vector3 deflection = Vector3::Zero();
  double largest = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double velocity = 0.4 * std::sin(2e-3 * i) + 0.2 * std::sin(1.7e-2 * i), load = 2.0 + 1e-4 * i;
    deflection = bend(law, deflection, velocity * line, load, step_of_bristles);
    const double force = bow.force(velocity, load);
    bow.advance(velocity, load);
    ASSERT_NEAR((deflection - bow.deflection() * line).norm(), 0.0, 1e-17) << i;
    ASSERT_NEAR((force_of_bristles(law, deflection, velocity * line, load) - force * line).norm(), 0.0, 1e-10) << i;
    largest = std::max(largest, force / load);
  }
  EXPECT_GT(largest, 0.6);
}

TEST(Bristles, FollowACurveWithTheForceOfSteadySliding) {
  const friction::Law law = soft_bristles();
  constexpr double speed = 0.2, load = 3.0;
  const double rate = 0.005 * speed / friction::sliding_deflection(law, speed, load);  // of turning, 1/s
  Vector3 deflection = Vector3::Zero(), velocity = Vector3::Zero();
  for (int i = 0; i * step_of_bristles * rate < 7; ++i) {
    const double angle = rate * step_of_bristles * i;
    velocity = speed * Vector3(std::cos(angle), std::sin(angle), 0);
    deflection = bend(law, deflection, velocity, load, step_of_bristles);
  }
  const double expected = load * (0.3 + 0.5 * std::exp(-4.0)) + law.viscosity * speed;
  const Vector3 force = force_of_bristles(law, deflection, velocity, load);
  EXPECT_NEAR(force.dot(velocity) / (speed * expected), 1.0, 1e-3);
  // Bristles that slide lag behind by the way that they bend: an angle of rate z_v/speed.
  EXPECT_NEAR(velocity.cross(deflection).z() / (speed * deflection.norm()), -0.005, 2e-4);
}

/// Any law, by numbers between 0 and 1.
template <class Any>
friction::Law any_law(Any any) {
  return {.sticking = 0.3 + any(),
          .sliding = 0.3 * any() + 0.001,
          .stribeck_speed = std::pow(10.0, -3.0 * any()),
          .stiffness = std::pow(10.0, 2.0 + 5.0 * any()),
          .damping = 100.0 * any(),
          .viscosity = any(),
          .break_away = 0.99 * any()};
}

TEST(Bristles, NeverGiveMoreThanTheyWereGiven) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    const friction::Law law = any_law([&] { return any(random); });
    Vector3 deflection = Vector3::Zero();
    for (int i = 0; i < 100; ++i) {
      const double speed = std::pow(any(random), 3.0), load = 5.0 * any(random) + 1e-9;
      const Vector3 velocity = speed * Vector3(any(random) - 0.5, any(random) - 0.5, any(random) - 0.5);
      const double before = 0.5 * law.stiffness * deflection.squaredNorm();
      deflection = bend(law, deflection, velocity, load, step_of_bristles);
      const double work = step_of_bristles * force_of_bristles(law, deflection, velocity, load).dot(velocity);
      const double after = 0.5 * law.stiffness * deflection.squaredNorm();
      ASSERT_GE(work + before - after, -1e-13 * (std::abs(work) + before + after)) << trial << " " << i;
      ASSERT_LE(law.stiffness * deflection.norm(), law.sticking * load * (1 + 1e-12));
    }
  }
}

/// The share of the load under which bristles bend is not the one under which they unbend.
TEST(Bristles, OfANodeNeverGiveMoreThanTheyWereGivenHoweverTheLoadMoves) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    const friction::Law law = any_law([&] { return any(random); });
    const double reach = law.sliding / law.stiffness / step_of_bristles;  // m/s that bends them in a step
    const auto stored = [&](const NodeBristles& node) {
      return 0.5 * law.stiffness * node.share * node.deflection.squaredNorm();
    };
    NodeBristles node;
    for (int i = 0; i < 100; ++i) {
      const double share = any(random), load = 1.0 + any(random), speed = 3.0 * reach * std::pow(any(random), 3.0);
      const Vector3 velocity = speed * Vector3(any(random) - 0.5, any(random) - 0.5, any(random) - 0.5);
      const double before = stored(node);
      node = bend(law, node, velocity, load, share, step_of_bristles);
      const double force = share * force_of_bristles(law, node.deflection, velocity, load).dot(velocity);
      const double work = step_of_bristles * force, after = stored(node);
      ASSERT_GE(node.share, share);
      ASSERT_GE(work + before - after, -1e-13 * (std::abs(work) + before + after)) << trial << " " << i;
    }
  }
}

TEST(Bristles, KeepTheirForceWhereLoadComesAndTheirDeflectionWhereItLeaves) {
  const NodeBristles bent{{3e-6, -4e-6, 0}, 0.5};
  const NodeBristles more = carry(bent, 0.8), fewer = carry(bent, 0.1);
  EXPECT_LT((more.share * more.deflection - bent.share * bent.deflection).norm(), 1e-21);
  EXPECT_EQ(more.share, 0.8);
  EXPECT_EQ(fewer.deflection, bent.deflection);
  EXPECT_EQ(fewer.share, 0.5);
}

TEST(Bristles, ForgetTheShareOfOldAsTheySlide) {
  friction::Law law = soft_bristles();
  law.break_away = 0.99;
  constexpr double load = 3.0, share = 0.2, speed = 1.0;
  const double length = friction::sliding_deflection(law, speed, load);
  NodeBristles node{Vector3(length, 0, 0), 0.9};
  for (int i = 0; i < 1000; ++i) {  // on a way as long as the deflection
    node = bend(law, node, Vector3(speed, 0, 0), load, share, 1e-3 * length / speed);
  }
  EXPECT_NEAR(node.deflection.x(), length, 1e-3 * length);
  EXPECT_NEAR(node.share - share, 0.7 * std::exp(-2.0), 1e-3);
}

TEST(Bristles, DoNotPullWithoutALoad) {
  const friction::Law law = soft_bristles();
  const Vector3 velocity(0.5, 0, 0);
  for (const double load : {1e-3, 1e-6, 1e-9}) {
    const Vector3 deflection = bend(law, Vector3::Zero(), velocity, load, step_of_bristles);
    const double most = law.sticking + 4 * law.sliding + law.sticking;  // bristles, their damping, viscosity
    EXPECT_LT(force_of_bristles(law, deflection, velocity, load).norm(), most * load);
  }
}

TEST(Bristles, AtRestHaveNoForce) {
  const friction::Law law = soft_bristles();
  const Vector3 none = bend(law, Vector3::Zero(), Vector3::Zero(), 1.0, step_of_bristles);
  EXPECT_EQ(none, Vector3::Zero());
  EXPECT_EQ(force_of_bristles(law, none, Vector3::Zero(), 1.0), Vector3::Zero());
}

}  // namespace
}  // namespace idiophone::contact
