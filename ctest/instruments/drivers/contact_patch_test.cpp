#include "contact_patch.hpp"

#include <gtest/gtest.h>

namespace idiophone::drivers {
namespace {

/// Mean and covariance of points with equal weights.
ContactPatch patch_of(const std::vector<Vector3>& points) {
  MeanPatch mean;
  for (const Vector3& point : points) {
    mean.add({.middle = point}, 0.25);
  }
  return mean.mean();
}

TEST(ContactPatch, OfLessThanAMillimetreIsAPoint) {
  const Vector3 middle(0.1, 0.2, 0.3);
  EXPECT_EQ((ContactPatch{.middle = middle, .spread = 0.9e-6 * Eigen::Matrix3d::Identity()}.points()),
            std::vector<Vector3>{middle});
  const ContactPatch rounded{.middle = middle, .spread = -1e-15 * Eigen::Matrix3d::Identity()};
  EXPECT_EQ(rounded.points(), std::vector<Vector3>{middle});
}

TEST(ContactPatch, ItsPointsHaveItsMeanAndCovariance) {
  const Vector3 along = Vector3(3, 4, 0) / 5.0, across(0, 0, 1);
  const Eigen::Matrix3d line = 4e-4 * along * along.transpose();
  const Eigen::Matrix3d rectangle = line + 1e-4 * across * across.transpose();
  const Vector3 middle(0.1, -0.2, 0.3);
  for (const Eigen::Matrix3d& spread : {line, rectangle}) {
    const ContactPatch found = patch_of(ContactPatch{.middle = middle, .spread = spread}.points());
    EXPECT_LT((found.middle - middle).norm(), 1e-15);
    EXPECT_LT((found.spread - spread).norm(), 1e-15);
  }
}

TEST(ContactPatch, PointsOfARoundOneDoNotJump) {
  const Eigen::Matrix3d round = Vector3(1e-4, 1e-4, 0).asDiagonal();
  Eigen::Matrix3d disturbed = round;
  disturbed(0, 1) = disturbed(1, 0) = 1e-14;
  const std::vector<Vector3> points = ContactPatch{.spread = round}.points();
  const std::vector<Vector3> others = ContactPatch{.spread = disturbed}.points();
  ASSERT_EQ(points.size(), others.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((points[i] - others[i]).norm(), 1e-9);
  }
}

TEST(MeanPatch, WeightsPlacesByTheForce) {
  MeanPatch mean;
  mean.add({.middle = {0, 0, 0}}, 1.0);
  mean.add({.middle = {4, 0, 0}}, 3.0);
  EXPECT_EQ(mean.mean().middle, Vector3(3, 0, 0));
  EXPECT_EQ(mean.mean().spread(0, 0), 3.0);
}

}  // namespace
}  // namespace idiophone::drivers
