// Constants that are moved by estimates.

#include "idiophone/study/fitting/material_slopes.hpp"

#include <gtest/gtest.h>

#include "bars.hpp"
#include "frequency_model.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

ON_RANKS(1);

TEST(StablePart, IsAllOfWhatTheMaterialBears) {
  scene::Material material;
  material.young = 7e10;
  material.poisson = 0.34;
  const Eigen::Vector2d small(0.3, 0.15);
  EXPECT_EQ(stable_part(material, small), small);
  EXPECT_NEAR(moved(material, small).poisson, 0.49, 1e-12);
}

// A ratio of 0.34 + 0.3 is past the limit 0.5; five tenths of the way it is 0.49.
TEST(StablePart, EndsBeforePoissonsRatioReachesItsLimits) {
  scene::Material material;
  material.young = 7e10;
  material.poisson = 0.34;
  const Eigen::Vector2d large(0.2, 0.3);
  EXPECT_NEAR((stable_part(material, large) - 0.5 * large).norm(), 0, 1e-12);
  const Eigen::Vector2d low(0.0, -2.0);
  EXPECT_NEAR(stable_part(material, low)[1], -1.2, 1e-12);
  material.poisson = 0.499999;
  EXPECT_EQ(stable_part(material, large), Eigen::Vector2d(0, 0));
}

TEST(StablePart, OfWoodIsStableWhereTheWholeIsNot) {
  const scene::Material wood = spruce();
  Eigen::VectorXd amounts = Eigen::VectorXd::Zero(9);
  amounts.segment(3, 3).setConstant(1.0);
  ASSERT_FALSE(is_stable(moved(wood, amounts)));
  const Eigen::VectorXd part = stable_part(wood, amounts);
  EXPECT_TRUE(is_stable(moved(wood, part)));
  EXPECT_GT(part.norm(), 0);
  EXPECT_FALSE(is_stable(moved(wood, part + 0.1 * amounts)));
}

}  // namespace
}  // namespace idiophone::fitting
