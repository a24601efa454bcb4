#include "mean_motion.hpp"
#include "ranks.hpp"

#include <gtest/gtest.h>

namespace idiophone::contact {
namespace {

ON_RANKS(1);

TEST(MeanMotion, IsTheMeanInTimeOfTheForceAndTheMeanByForceOfItsPlace) {
  MeanMotion mean;
  mean.add({.force = {0, 0, 1}, .point = {1, 0, 0}, .normal = {0, 0, 1}, .slip = {4, 0, 0}, .overlap = 2});
  mean.add({.force = {0, 3, 0}, .point = {5, 0, 0}, .normal = {0, 1, 0}, .slip = {0, 4, 0}, .overlap = 4});
  mean.add({});  // a step without touch
  mean.add({});
  const ContactMotion found = mean.take();
  EXPECT_EQ(found.force, Vector3(0, 0.75, 0.25));
  EXPECT_EQ(found.overlap, 1.5);
  EXPECT_EQ(found.point, Vector3(4, 0, 0));
  EXPECT_LT((found.normal - Vector3(0, 3, 1).normalized()).norm(), 1e-15);
  EXPECT_EQ(found.slip, Vector3(1, 3, 0));
}

TEST(MeanMotion, SpreadIsThatOfThePlacesAndOfTheirWay) {
  MeanMotion mean;
  const Eigen::Matrix3d still = Vector3(0, 0.5, 0).asDiagonal();
  mean.add({.force = {0, 0, 1}, .point = {1, 0, 0}, .spread = still});
  mean.add({.force = {0, 0, 3}, .point = {5, 0, 0}, .spread = still});
  const Eigen::Matrix3d expected = Vector3(3, 0.5, 0).asDiagonal();
  EXPECT_EQ(mean.take().spread, expected);
}

TEST(MeanMotion, BeginsAnewWhenItIsTaken) {
  MeanMotion mean;
  mean.add({.force = {0, 0, 1}, .overlap = 2});
  EXPECT_EQ(mean.take().overlap, 2);
  EXPECT_EQ(mean.take().force, Vector3::Zero());
  mean.add({.force = {0, 0, 6}, .normal = {0, 0, 1}});
  EXPECT_EQ(mean.take().force, Vector3(0, 0, 6));
}

TEST(MeanMotion, WithoutTouchIsZero) {
  MeanMotion mean;
  mean.add({});
  const ContactMotion found = mean.take();
  EXPECT_EQ(found.normal, Vector3::Zero());
  EXPECT_EQ(found.point, Vector3::Zero());
}

}  // namespace
}  // namespace idiophone::contact
