#include "idiophone/solids/eigenmodes/is_rigid_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

ON_RANKS(1);

/// Points along a bar of 1 m, most of them at its end.
Eigen::Matrix3Xd heavy_ended_bar() {
  Eigen::Matrix3Xd places = Eigen::Matrix3Xd::Zero(3, 100);
  places.row(0).setOnes();
  places.row(0).head(11).setLinSpaced(0.0, 1.0);
  places.row(1) = 0.01 * Eigen::RowVectorXd::Random(100);
  places.row(2) = 0.01 * Eigen::RowVectorXd::Random(100);
  return places;
}

/// A motion a + b x r.
Eigen::Matrix3Xd rigid_motion(const Eigen::Matrix3Xd& places) {
  const Eigen::Vector3d shift(0.3, -0.2, 0.5), turn(0.1, 0.7, -0.4);
  return (-places.colwise().cross(turn)).colwise() + shift;
}

TEST(IsRigidMotion, KnowsShiftsWithTurns) {
  const Eigen::Matrix3Xd places = heavy_ended_bar();
  EXPECT_TRUE(is_rigid_motion(places, rigid_motion(places)));
  EXPECT_TRUE(is_rigid_motion(places, 1e-9 * rigid_motion(places))) << "the unit does not matter";
}

TEST(IsRigidMotion, AllowsATenthOfTheLargestDisplacementAtEachPoint) {
  const Eigen::Matrix3Xd places = heavy_ended_bar();
  const Eigen::Matrix3Xd unbent = rigid_motion(places);
  const double largest = unbent.colwise().norm().maxCoeff();
  for (const double share : {0.05, 0.2}) {
    Eigen::Matrix3Xd bent = unbent;
    bent(2, 5) += share * largest;
    EXPECT_EQ(is_rigid_motion(places, bent), share < 0.1) << share;
  }
}

TEST(IsRigidMotion, IsNotDecidedByTheHeavyEndOfACantilever) {
  const Eigen::Matrix3Xd places = heavy_ended_bar();
  Eigen::Matrix3Xd bending = Eigen::Matrix3Xd::Zero(3, places.cols());
  bending.row(2) = places.row(0).array().square() * (3 - places.row(0).array()) / 2;  // under a force at its end
  EXPECT_FALSE(is_rigid_motion(places, bending));
}

}  // namespace
}  // namespace idiophone::eigenmodes
