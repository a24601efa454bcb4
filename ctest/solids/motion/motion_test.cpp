#include "idiophone/solids/motion/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

/// What the block consists of.
struct Kind {
  element::Type type;
  std::optional<scene::MassScalingLimit> scaling;
};

/// Scaling is large where only low frequencies are to be heard.
Laboratory block(const Kind& kind) {
  Laboratory lab(support::block_mesh(kind.type, {0.2, 0.1, 0.05}, {4, 2, 1}));
  lab.scene.bodies[0].mass_scaling = kind.scaling;
  lab.scene.audio.max_frequency = 10;
  return lab;
}

class MotionTest : public ::testing::TestWithParam<Kind> {
 protected:
  MotionTest() : lab(block(GetParam())) {}
  /// Well inside the stable step: edges of 0.05 m (or half that), waves of 37 m/s.
  static constexpr double step = 5e-5;
  Laboratory lab;
};

ON_RANKS(1);

TEST_P(MotionTest, FreeFallIsExact) {
  lab.scene.gravity = {0, 0, -9.81};
  lab.scene.bodies[0].velocity = {1, 2, 3};
  lab.begin(step);
  lab.advance(1000);
  const double t = 1000 * step;
  const Vector3 expected = t * lab.scene.bodies[0].velocity + t * t / 2 * lab.scene.gravity;
  for (std::size_t node = 0; node < lab.mesh.nodes.size(); ++node) {
    EXPECT_LT((lab.displacement(node) - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST_P(MotionTest, CountsStepsBeyond32Bits) {
  lab.scene.gravity = {0, 0, -9.81};
  lab.begin(step);
  const std::int64_t many = (std::int64_t{1} << 31) - 2;
  lab.go_on(*lab.motion, many);
  lab.advance(4);
  EXPECT_EQ(lab.motion->step_number(), many + 4);
  EXPECT_EQ(lab.motion->time(), static_cast<double>(many + 4) * step);
  EXPECT_NEAR(lab.displacement(0).z() / (-9.81 * step * step * (1 + 2 + 3 + 4)), 1.0, 1e-12);
}

TEST_P(MotionTest, SpinningVibratingFreeBodyKeepsItsMomenta) {
  lab.scene.bodies[0].velocity = {0.5, 0, 0};
  lab.scene.bodies[0].spin = {10, -20, 30};
  lab.scene.materials[0].damping.stiffness = 1e-6;
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.begin(step);
  lab.advance(120);
  const BodyMotion early = lab.observe();
  lab.advance(2000);
  const BodyMotion late = lab.observe();
  EXPECT_GT(early.elastic, 1e-5);
  EXPECT_LT((late.velocity - early.velocity).norm(), 1e-12 * early.velocity.norm());
  EXPECT_LT((late.angular_momentum - early.angular_momentum).norm(), 1e-12 * early.angular_momentum.norm());
}

TEST_P(MotionTest, ABalancedPulseMakesTheBodyVibrateButNotMoveAsAWhole) {
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.begin(step);
  lab.advance(120);
  const BodyMotion pushed = lab.observe();
  lab.scene.pulses[0].is_balanced = true;
  lab.begin(step);
  lab.advance(120);
  const BodyMotion balanced = lab.observe();
  EXPECT_GT(pushed.velocity.norm(), 1e-2);
  EXPECT_GT(pushed.angular_momentum.norm(), 1e-4);
  EXPECT_LT(balanced.velocity.norm(), 1e-12 * pushed.velocity.norm());
  EXPECT_LT(balanced.angular_momentum.norm(), 2e-4 * pushed.angular_momentum.norm());  // the body bends meanwhile
  EXPECT_NEAR(balanced.elastic / pushed.elastic, 1.0, 0.05);  // the body that is pushed turns, too
}

TEST_P(MotionTest, DampingOfVibrationKeepsTheMomenta) {
  lab.scene.bodies[0].velocity = {0.5, 0, 0};
  lab.scene.bodies[0].spin = {1, -2, 3};
  lab.scene.materials[0].damping.mass = 20;
  lab.scene.materials[0].damping.mass_of = scene::DampedMotion::vibration;
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.begin(step);
  lab.advance(120);
  const BodyMotion early = lab.observe();
  lab.advance(2000);
  const BodyMotion late = lab.observe();
  EXPECT_LT(late.elastic, 0.5 * early.elastic);
  EXPECT_LT((late.velocity - early.velocity).norm(), 1e-12 * early.velocity.norm());
  EXPECT_LT((late.angular_momentum - early.angular_momentum).norm(), 1e-12 * early.angular_momentum.norm());
}

TEST_P(MotionTest, DampingOfVibrationTakesTheEnergyThatMassDampingTakes) {
  lab.scene.materials[0].damping.mass = 5;
  lab.scene.materials[0].damping.mass_of = scene::DampedMotion::vibration;
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.scene.pulses[0].is_balanced = true;
  lab.begin(step);
  const auto mean_energy = [&] {
    double sum = 0.0;
    for (int sample = 0; sample < 200; ++sample) {
      lab.advance(10);
      const BodyMotion now = lab.observe();
      sum += now.kinetic + now.elastic;
    }
    return sum;
  };
  lab.advance(120);
  const double early = mean_energy();
  EXPECT_NEAR(mean_energy() / early, std::exp(-5 * 2000 * step), 0.02);
}

TEST_P(MotionTest, UndampedEnergyStaysWithinAThousandthAndDoesNotDrift) {
  lab.scene.bodies[0].spin = {0, 0, 20};
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.begin(step);
  lab.advance(120);
  const auto energy = [&] {
    const BodyMotion now = lab.observe();
    return now.kinetic + now.elastic;
  };
  const double start = energy();
  double first_half = 0.0;
  double second_half = 0.0;
  for (int sample = 0; sample < 400; ++sample) {
    lab.advance(25);
    (sample < 200 ? first_half : second_half) += energy() / start / 200;
    EXPECT_NEAR(energy() / start, 1.0, 1e-3);
  }
  RecordProperty("drift", std::to_string(second_half / first_half - 1));
  EXPECT_NEAR(second_half / first_half, 1.0, 2e-5);
  // What the body holds is what the pulse has put in (and the spin it began with).
  EXPECT_GT(lab.motion->work().value(), 0.0);
}

TEST_P(MotionTest, ConvergesWithSecondOrderInTime) {
  const auto solve = [](int refinement, double stiffness_damping) {
    Laboratory fresh = block(GetParam());
    fresh.scene.materials[0].damping = {50, stiffness_damping};
    fresh.scene.bodies[0].spin = {0, 0, 20};
    fresh.push("x1", {0, 3, 10}, 5e-3);
    fresh.begin(4e-5 / refinement);
    fresh.advance(250 * refinement);
    return std::vector<NodeState>(fresh.motion->state());
  };
  const auto difference = [](const std::vector<NodeState>& a, const std::vector<NodeState>& b) {
    double sum = 0.0;
    for (std::size_t node = 0; node < a.size(); ++node) {
      for (int i = 0; i < 3; ++i) {
        sum += std::pow(a[node].displacement[i] - b[node].displacement[i], 2);
      }
    }
    return std::sqrt(sum);
  };
  const auto coarse = solve(2, 0);
  const auto middle = solve(4, 0);
  const auto fine = solve(8, 0);
  EXPECT_NEAR(std::log2(difference(coarse, middle) / difference(middle, fine)), 2.0, 0.1);
}

TEST_P(MotionTest, MassDampingSlowsATranslationExponentially) {
  lab.scene.materials[0].damping.mass = 100;
  lab.scene.bodies[0].velocity = {1, 0, 0};
  lab.begin(step);
  lab.advance(400);
  const double expected = (1 - std::exp(-100 * 400 * step)) / 100;
  EXPECT_NEAR(lab.displacement(0)[0] / expected, 1.0, 1e-5);
}

TEST_P(MotionTest, DrivenGroupFollowsItsSignalAndFixedGroupStays) {
  lab.fix("x0");
  scene::DrivenGroup driven;
  driven.group = "x1";
  driven.axes = {true, false, true};
  driven.displacement = {0.002, 0, 0.001};
  driven.signal = {scene::Signal::Shape::sine, 0.0, std::numeric_limits<double>::infinity(), 50.0, {}};
  lab.scene.bodies[0].driven.push_back(driven);
  lab.attachments.bodies[0].driven.push_back({lab.mesh.groups.at("x1"), {}});
  constexpr double short_step = step / 10;  // the sum of the work is of first order in the step
  lab.begin(short_step);
  lab.advance(770);
  const double factor = std::sin(2 * std::numbers::pi * 50 * 770 * short_step);
  for (const Index node : lab.mesh.groups.at("x1")) {
    const Vector3 u = lab.displacement(static_cast<std::size_t>(node));
    EXPECT_NEAR(u[0], 0.002 * factor, 1e-16);
    EXPECT_NEAR(u[2], 0.001 * factor, 1e-16);
  }
  for (const Index node : lab.mesh.groups.at("x0")) {
    EXPECT_EQ(lab.displacement(static_cast<std::size_t>(node)).norm(), 0.0);
  }
  // The energy in the body came from the drive.
  const BodyMotion now = lab.observe();
  EXPECT_NEAR(lab.motion->work().value() / (now.kinetic + now.elastic), 1.0, 0.02);
}

TEST_P(MotionTest, GoesOnFromASavedStateToTheBit) {
  lab.scene.bodies[0].spin = {0, 0, 20};
  lab.scene.materials[0].damping = {1, 1e-6};
  lab.push("x1", {0, 3, 10}, 5e-3);
  expect_a_saved_state_to_go_on(lab, step, 30);
}

TEST_P(MotionTest, MeasuringChangesNothing) {
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.begin(step);
  lab.advance(20);
  const auto before = Laboratory::saved(*lab.motion);
  (void)lab.observe();
  EXPECT_EQ(before, Laboratory::saved(*lab.motion));
}

TEST_P(MotionTest, AngularVelocityIsThatOfTheSpin) {
  lab.scene.bodies[0].spin = {10, -20, 30};
  lab.begin(step);
  const BodyMotion start = lab.observe();
  EXPECT_LT((start.angular_velocity - lab.scene.bodies[0].spin).norm(), 1e-11 * lab.scene.bodies[0].spin.norm());
  EXPECT_NEAR(start.kinetic, start.angular_momentum.dot(start.angular_velocity) / 2, 1e-12 * start.kinetic);
}

std::string name(const ::testing::TestParamInfo<Kind>& kind) {
  return std::string(element::name(kind.param.type)) + (kind.param.scaling ? "_scaled" : "");
}

INSTANTIATE_TEST_SUITE_P(Types, MotionTest,
                         ::testing::Values(Kind{element::tet4, {}}, Kind{element::tet10, {}},
                                           Kind{element::hex(2, 2), {}},
                                           Kind{element::hex(2, 2), scene::MassScalingLimit{.shift = 50}}),
                         name);

}  // namespace
}  // namespace idiophone::motion
