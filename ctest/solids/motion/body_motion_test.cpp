#include "idiophone/solids/motion/body_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;

/// Angle between two rotations, rad.
double angle(const Quaterniond& a, const Quaterniond& b) {
  return 2 * (a * b.conjugate()).vec().norm();
}

/// A brick that can be put anywhere, deformed and moving.
class Brick : public ::testing::Test {
 protected:
  explicit Brick(double size = 0.1) : lab(support::block_mesh(element::tet10, {3 * size, 2 * size, size}, {3, 2, 1})) {
    lab.begin(step);
  }

  /// x = centre + stretch (X - C), moving like a rigid body.
  void put(const Vector3& centre, const Matrix3d& stretch, const Vector3& drift, const Vector3& rate) {
    std::vector<double> rows;
    for (const Vector3& reference : lab.mesh.nodes) {
      const Vector3 arm = stretch * (reference - lab.initial_state.centres[0]);
      const Vector3 u = centre + arm - reference;
      const Vector3 v = drift + rate.cross(arm);
      rows.insert(rows.end(), u.begin(), u.end());
      rows.insert(rows.end(), v.begin(), v.end());
    }
    lab.put(rows);
  }

  static constexpr double step = 1e-5;
  Laboratory lab;
  const Quaterniond turn{AngleAxisd(2.5, Vector3(1, -2, 0.5).normalized())};
  const Vector3 velocity = {3, -4, 12};
  const Vector3 spin = {20, 50, -30};
};

ON_RANKS(1);

TEST_F(Brick, IsNotTurnedAtRest) {
  const BodyMotion seen = lab.observe();
  EXPECT_LT((seen.centre - Vector3(0.15, 0.1, 0.05)).norm(), 1e-3);  // the lumped masses of its mesh are not symmetric
  EXPECT_LT(angle(seen.orientation, Quaterniond::Identity()), 1e-14);
  EXPECT_EQ(seen.velocity.norm(), 0);
  EXPECT_EQ(seen.angular_velocity.norm(), 0);
  EXPECT_EQ(seen.elastic, 0);
}

TEST_F(Brick, TurnedAndCarriedAwayIsSeenSo) {
  put({1, 2, 3}, turn.toRotationMatrix(), velocity, spin);
  const BodyMotion seen = lab.observe();
  EXPECT_LT((seen.centre - Vector3(1, 2, 3)).norm(), 1e-13);
  EXPECT_LT((seen.velocity - velocity).norm(), 1e-13);
  EXPECT_LT(angle(seen.orientation, turn), 3e-13);  // rounding of displacements of 4 m
  EXPECT_LT((seen.angular_velocity - spin).norm(), 1e-11 * spin.norm());
  EXPECT_NEAR(seen.orientation.norm(), 1, 1e-15);
  const Matrix3d moment = turn * lab.initial_state.moments[0] * turn.conjugate();
  const Matrix3d inertia = moment.trace() * Matrix3d::Identity() - moment;
  EXPECT_LT((seen.angular_momentum - inertia * spin).norm(), 1e-11 * (inertia * spin).norm());
  EXPECT_NEAR(seen.kinetic, lab.initial_state.masses[0] * velocity.squaredNorm() / 2 + spin.dot(inertia * spin) / 2,
              1e-10);
}

TEST_F(Brick, InertiaIsThatOfTheDeformedBody) {
  // Stretched before it is turned, by a tensor that has the second moments' principal axes.
  const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(lab.initial_state.moments[0]);
  const Matrix3d& axes = principal.eigenvectors();
  const Matrix3d stretch = axes * Vector3(1.2, 0.9, 1.1).asDiagonal() * axes.transpose();
  put({0, 0, 0}, turn * stretch, {0, 0, 0}, spin);
  const BodyMotion seen = lab.observe();
  EXPECT_LT(angle(seen.orientation, turn), 1e-13);
  EXPECT_LT((seen.angular_velocity - spin).norm(), 1e-12 * spin.norm());
}

TEST_F(Brick, SumsThatAreNotValidBecomeNotANumber) {
  put({1e200, 0, 0}, Matrix3d::Identity(), {0, 0, 0}, spin);
  const BodyMotion seen = lab.observe();
  EXPECT_TRUE(std::isnan(seen.centre[0]));
  EXPECT_TRUE(std::isnan(seen.orientation.w()));
  EXPECT_TRUE(std::isnan(seen.angular_velocity[0]));
}

/// From dust to rocks, at home and a thousand sizes away.
class AnySize : public Brick, public ::testing::WithParamInterface<double> {
 protected:
  AnySize() : Brick(GetParam()) {}
};

TEST_P(AnySize, IsMeasuredToElevenDigits) {
  put({0, 0, 0}, turn.toRotationMatrix(), {0, 0, 0}, spin);
  const BodyMotion seen = lab.observe();
  EXPECT_LT(angle(seen.orientation, turn), 1e-13);
  EXPECT_LT((seen.angular_velocity - spin).norm(), 1e-11 * spin.norm());
}

TEST_P(AnySize, KeepsEightDigitsAThousandSizesAway) {
  put(GetParam() * Vector3(800, 0, 600), turn.toRotationMatrix(), 1000 * GetParam() * velocity, spin);
  const BodyMotion seen = lab.observe();
  EXPECT_LT(angle(seen.orientation, turn), 1e-11);
  EXPECT_LT((seen.angular_velocity - spin).norm(), 1e-8 * spin.norm());
}

INSTANTIATE_TEST_SUITE_P(Sizes, AnySize, ::testing::Values(1e-5, 1e-3, 1.0, 100.0));

/// Six tetrahedra around the diagonal of a cube make a symmetric top: the mesh is the same under every exchange of the
/// axes, so two of the principal moments of its lumped masses agree. Of steel, which stretches by some 4e-8 at this
/// spin.
class SymmetricTop : public ::testing::Test {
 protected:
  SymmetricTop() : lab(support::block_mesh(element::tet4, {0.01, 0.01, 0.01}, {1, 1, 1})) {
    lab.scene.materials[0] = {"steel", 2e11, 0.3, 7850, {0, 0}, {}};
    lab.scene.bodies[0].velocity = {0.3, 0.1, -0.2};
    lab.scene.bodies[0].spin = {-40, 100, 60};
    lab.begin(step);
  }

  static constexpr double step = 4e-7;
  Laboratory lab;
};

TEST_F(SymmetricTop, NutatesAsEulerSays) {
  const Vector3 axis = Vector3(1, 1, 1).normalized();
  const BodyMotion start = lab.observe();
  const Vector3 spin = lab.scene.bodies[0].spin;
  EXPECT_LT((start.angular_velocity - spin).norm(), 1e-11 * spin.norm());
  const Matrix3d inertia = lab.initial_state.moments[0].trace() * Matrix3d::Identity() - lab.initial_state.moments[0];
  const double along = axis.dot(inertia * axis);
  const double across = (inertia.trace() - along) / 2;
  ASSERT_GT(across / along, 1.5);
  // Landau and Lifshitz, Mechanics, section 33: the axis precesses about the angular momentum, the body spins about it.
  const double precession = start.angular_momentum.norm() / across;
  const double own_spin = (1 - along / across) * spin.dot(axis);
  for (int part = 1; part <= 20; ++part) {
    lab.advance(10000);
    const double time = lab.motion->time();
    const Quaterniond turn = AngleAxisd(precession * time, start.angular_momentum.normalized()) *
                             Quaterniond(AngleAxisd(own_spin * time, axis));
    const Vector3 expected = start.angular_momentum / across + own_spin * (turn * axis);
    const BodyMotion seen = lab.observe();
    EXPECT_LT((seen.angular_momentum - start.angular_momentum).norm(), 1e-11 * start.angular_momentum.norm());
    EXPECT_LT(angle(seen.orientation, turn), 1e-6) << time;
    EXPECT_LT((seen.angular_velocity - expected).norm(), 1e-6 * spin.norm()) << time;
  }
}

}  // namespace
}  // namespace idiophone::motion
