#include "floating_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace idiophone::modal_bodies {
namespace {

const Eigen::Matrix3d no_change = Eigen::Matrix3d::Zero();

/// A symmetric top, about z.
FloatingFrame top(double damping = 0.0, const Vector3& gravity = Vector3::Zero()) {
  return {2.0, Vector3(0.003, 0.003, 0.001).asDiagonal(), damping, gravity};
}

void advance(FloatingFrame& frame, int steps, double step, const Vector3& force = Vector3::Zero(),
             const Vector3& torque = Vector3::Zero()) {
  for (int n = 0; n < steps; ++n) {
    frame.advance({n, step}, force, torque, no_change);
  }
}

TEST(FloatingFrame, FallsExactly) {
  FloatingFrame frame = top(0.0, {0, 0, -9.81});
  frame.start(Vector3::Zero(), Eigen::Quaterniond::Identity(), {1, 2, 3}, Vector3::Zero());
  advance(frame, 1000, 1e-3);
  EXPECT_LT((frame.shift() - Vector3(1, 2, 3 - 9.81 / 2)).norm(), 1e-12);
  EXPECT_TRUE(frame.turn_less_one().isZero(0.0));
}

TEST(FloatingFrame, SymmetricTopPrecessesAsEulerSays) {
  // I_1 = I_2 = 0.004, I_3 = 0.006 kg m2: its axis goes around the angular momentum at |L|/I_1.
  const Vector3 spin(2, 0, 10);
  const Vector3 momentum(0.004 * 2, 0, 0.006 * 10);
  double before = 0.0;
  for (const int steps : {1000, 2000}) {
    FloatingFrame frame = top();
    frame.start(Vector3::Zero(), Eigen::Quaterniond::Identity(), Vector3::Zero(), spin);
    advance(frame, steps, 1.0 / steps);
    const Vector3 axis = Eigen::AngleAxisd(momentum.norm() / 0.004, momentum.normalized()) * Vector3::UnitZ();
    const double error = (frame.turn().col(2) - axis).norm();
    EXPECT_LT(error, 1e-3);
    EXPECT_TRUE(before == 0.0 || std::abs(std::log2(before / error) - 2) < 0.1) << before << " " << error;
    before = error;
    const FloatingFrame::Motion now = frame.now({steps, 1.0 / steps}, Vector3::Zero(), Vector3::Zero(), no_change);
    EXPECT_LT((now.angular_momentum - momentum).norm(), 1e-15);
    EXPECT_NEAR(now.spin.dot(now.angular_momentum) / spin.dot(momentum), 1.0, 1e-4);
  }
}

TEST(FloatingFrame, SmallTurnsKeepAllTheirDigits) {
  FloatingFrame frame = top();
  frame.start(Vector3::Zero(), Eigen::Quaterniond::Identity(), Vector3::Zero(), {0, 0, 1e-9});
  advance(frame, 1, 1e-6);
  EXPECT_NEAR(frame.turn_less_one()(1, 0) / 1e-15, 1.0, 1e-12);
}

TEST(FloatingFrame, TorqueTurnsIt) {
  FloatingFrame frame = top();
  frame.start(Vector3::Zero(), Eigen::Quaterniond::Identity(), Vector3::Zero(), Vector3::Zero());
  advance(frame, 1000, 1e-3, Vector3::Zero(), {0, 0, 0.006});
  EXPECT_NEAR(std::atan2(frame.turn()(1, 0), frame.turn()(0, 0)), 0.5, 1e-9);
}

TEST(FloatingFrame, MassDampingSlowsItExponentially) {
  FloatingFrame frame = top(5.0);
  frame.start(Vector3::Zero(), Eigen::Quaterniond::Identity(), {1, 0, 0}, {0, 0, 1});
  advance(frame, 1000, 1e-3);
  EXPECT_NEAR(frame.shift().x() / ((1 - std::exp(-5.0)) / 5), 1.0, 1e-5);
  EXPECT_NEAR(frame.spin().z() / std::exp(-5.0 * 0.9995), 1.0, 1e-4);
}

}  // namespace
}  // namespace idiophone::modal_bodies
