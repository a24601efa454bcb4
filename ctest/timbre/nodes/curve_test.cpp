// Curves through given values.

#include <gtest/gtest.h>

#include "idiophone/timbre/nodes/curve.hpp"
#include "idiophone/timbre/nodes/curve_node.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Curves, AreConstantOutsideOfTheirTimes) {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic, Interpolation::hold}) {
    const Curve curve({1.0, 2.0, 4.0}, {3.0, 7.0, 5.0}, interpolation);
    EXPECT_EQ(curve.at(-1e9), 3.0);
    EXPECT_EQ(curve.at(0.999), 3.0);
    EXPECT_EQ(curve.at(4.0), 5.0);
    EXPECT_EQ(curve.at(1e9), 5.0);
    EXPECT_EQ(Curve({2.0}, {9.0}, interpolation).at(2.0), 9.0);
  }
}

TEST(Curves, PassThroughTheirValues) {
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic, Interpolation::hold}) {
    const Curve curve({1.0, 2.0, 4.0}, {3.0, 7.0, 5.0}, interpolation);
    EXPECT_EQ(curve.at(1.0), 3.0);
    EXPECT_EQ(curve.at(2.0), 7.0);
  }
}

TEST(Curves, AreLinearOrHoldBetweenTwoTimes) {
  EXPECT_EQ(Curve({1.0, 2.0, 4.0}, {3.0, 7.0, 5.0}, Interpolation::linear).at(2.5), 6.5);
  EXPECT_EQ(Curve({1.0, 2.0, 4.0}, {3.0, 7.0, 5.0}, Interpolation::hold).at(3.999), 7.0);
}

TEST(Curves, OfCubicsReproduceParabolasInside) {  // t^2 at uneven times: the slopes there are exact
  const Curve curve({0.0, 1.0, 3.0, 4.0, 6.0}, {0.0, 1.0, 9.0, 16.0, 36.0}, Interpolation::cubic);
  for (const double time : {1.0, 1.3, 2.0, 2.9, 3.0, 3.5, 3.99}) {
    EXPECT_NEAR(curve.at(time), time * time, 1e-12) << time;
  }
}

TEST(Curves, OfCubicsAreSmoothAndLevelAtTheirEnds) {
  const Curve curve({0.0, 1.0, 3.0}, {0.0, 5.0, -2.0}, Interpolation::cubic);
  constexpr double small = 1e-6;
  const auto slope = [&](double from) { return (curve.at(from + small) - curve.at(from)) / small; };
  EXPECT_NEAR(slope(0.0), 0.0, 1e-4);
  EXPECT_NEAR(slope(3.0 - small), 0.0, 1e-4);
  EXPECT_NEAR(slope(1.0), slope(1.0 - small), 1e-4);
  EXPECT_NEAR(slope(1.0), (5.0 * 2.0 / 1.0 - 7.0 * 1.0 / 2.0) / 3.0, 1e-4);  // of the parabola through the three
}

TEST(Curves, AreNodesInTheTimeOfTheScene) {
  CurveNode node(std::make_shared<const Curve>(std::vector{0.0, 10.0}, std::vector{0.0, 100.0}, Interpolation::linear),
                 2.0, 4);
  std::vector<double> samples(3);
  node.render({.first = 6, .count = 3}, {}, samples);
  EXPECT_EQ(samples, (std::vector{35.0, 37.5, 40.0}));
}

}  // namespace idiophone::timbre
