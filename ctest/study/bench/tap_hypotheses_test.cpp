// Which line of a tap is which mode.

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <random>

#include "doubt.hpp"
#include "tap_hypotheses.hpp"

namespace idiophone::bench {
namespace {

using Lines = std::vector<std::optional<std::size_t>>;

std::vector<fitting::Line> lines_at(const std::vector<double>& cents, double uncertainty = 1.0) {
  std::vector<fitting::Line> lines;
  for (const double value : cents) {
    lines.push_back({.frequency = std::exp2(value / 1200), .uncertainty = uncertainty});
  }
  return lines;
}

/// Two bending modes and a torsion between them. Unknowns: a shift of all, one of bending, and one of each mode.
ExpectedTap bar(double torsion, double own = 10.0, double bending = 60.0) {
  ExpectedTap expected{
      Eigen::Vector3d(7000, torsion, 10000), Eigen::MatrixXd::Zero(3, 5), Eigen::VectorXd(5), {0.8, 0.8, 0.8}};
  expected.slopes.col(0).setOnes();
  expected.slopes.col(1) << 1, 0, 1;
  expected.slopes.rightCols(3).setIdentity();
  expected.spread << 300, bending, own, own, own;
  return expected;
}

TEST(TapHypotheses, FindModesAfterACommonShift) {
  TapHypotheses taps(5);
  const auto lines = lines_at({7183, 8510, 9180, 10181});
  taps.hear(lines, bar(9000));
  EXPECT_EQ(taps.all().front().lines, (Lines{0, 2, 3}));
  const std::array<std::size_t, 3> modes = {0, 1, 2};
  EXPECT_GT(certainness_of(taps, modes, lines).probability, 0.99);
}

// The torsion is computed 30 cents below the bending mode, but the wood can put it above it.
TEST(TapHypotheses, DoubtWhereModesMayHaveChangedPlaces) {
  TapHypotheses taps(5);
  const auto lines = lines_at({7000, 9975, 10005});
  taps.hear(lines, bar(9970));
  const std::array<std::size_t, 2> bending = {0, 2};
  const Certainness certainness = certainness_of(taps, bending, lines);
  EXPECT_LT(certainness.probability, 0.99);
  ASSERT_NE(certainness.rival, nullptr);
  EXPECT_NE(certainness.rival->lines[2], taps.all().front().lines[2]);
  // The lowest mode is the same in all of them.
  const std::array<std::size_t, 1> lowest = {0};
  EXPECT_GT(certainness_of(taps, lowest, lines).probability, 0.99);
}

/// One way to take the lines.
TapHypothesis way(Lines lines) {
  return {{}, {}, 0.0, std::move(lines)};
}

TEST(Doubts, NameTheLineAndTheModesThatMayHaveIt) {
  const auto lines = lines_at({7000, 9000, 10000});
  // The modes 1 and 2 change their lines.
  const Doubt changed = doubt_between(way({0, 1, 2}), way({0, 2, 1}), 1, lines);
  EXPECT_EQ(changed.line, lines[1].frequency);
  EXPECT_EQ(changed.other, 2U);
  EXPECT_FALSE(changed.other_line);
  // The likeliest way gives the line at 10 000 cents to mode 2, the rival to mode 1, which has no other one.
  const Doubt stolen = doubt_between(way({0, std::nullopt, 2}), way({0, 2, std::nullopt}), 1, lines);
  EXPECT_EQ(stolen.line, lines[2].frequency);
  EXPECT_EQ(stolen.other, 2U);
  // Mode 1 may have a line that no mode has in the other way.
  const Doubt moved = doubt_between(way({0, 1, std::nullopt}), way({0, 2, std::nullopt}), 1, lines);
  EXPECT_EQ(moved.line, lines[1].frequency);
  EXPECT_EQ(moved.other_line, lines[2].frequency);
  EXPECT_FALSE(moved.other);
}

// The lines of mode 1 count as one, so it is mode 2 that the ways disagree about.
TEST(Doubts, AreAboutTheModeThatContradicts) {
  TapHypotheses taps(5);
  const auto lines = lines_at({7000, 7000.5, 9975, 10005});
  taps.hear(lines, bar(9970));
  const std::array<std::size_t, 2> modes = {0, 2};
  const Certainness certainness = certainness_of(taps, modes, lines);
  ASSERT_NE(certainness.rival, nullptr);
  EXPECT_EQ(certainness.mode, 2U);
}

TEST(TapHypotheses, KnowFromAQuietTapWhichLineIsWhich) {
  TapHypotheses taps(5);
  ExpectedTap middle = bar(9970);
  middle.heard[1] = 0.02;  // a tap in the middle of the width hardly excites torsion
  const auto first = lines_at({7000, 10000});
  taps.hear(first, middle);
  EXPECT_EQ(taps.all().front().lines, (Lines{0, std::nullopt, 1}));
  // With the next tap both are heard; what was learned tells them apart.
  ExpectedTap edge = bar(9970);
  edge.spread.setZero();
  const auto second = lines_at({7000, 9970, 10000});
  taps.hear(second, edge);
  EXPECT_EQ(taps.all().front().lines, (Lines{0, 1, 2}));
  const std::array<std::size_t, 2> bending = {0, 2};
  EXPECT_GT(certainness_of(taps, bending, second).probability, 0.99);
  TapHypotheses unlearned(5);
  unlearned.hear(second, bar(9970));
  EXPECT_LT(certainness_of(unlearned, bending, second).probability, 0.99);
}

TEST(TapHypotheses, GiveALineToOneModeOnly) {
  TapHypotheses taps(5);
  const auto lines = lines_at({7000, 10000});
  taps.hear(lines, bar(9990));
  for (const TapHypothesis& hypothesis : taps.all()) {
    EXPECT_FALSE(hypothesis.lines[1] && hypothesis.lines[1] == hypothesis.lines[2]);
  }
  const std::array<std::size_t, 1> bending = {2};
  EXPECT_LT(certainness_of(taps, bending, lines).probability, 0.99);
}

TEST(TapHypotheses, AreSureWhereTheChoiceMakesNoDifference) {
  TapHypotheses taps(5);
  const auto lines = lines_at({7000, 9999, 10001}, 3.0);
  taps.hear(lines, bar(10000));
  const std::array<std::size_t, 2> bending = {0, 2};
  EXPECT_GT(certainness_of(taps, bending, lines).probability, 0.99);
}

// Mode 1 is not in the second tap, before which cuts moved the modes by 40, 20 and 10 cents, and may have moved each by
// 5 more. The common part of what they did is learned from the other modes, and its own part is not.
TEST(TapHypotheses, KeepTheLineOfAModeThatALaterTapMisses) {
  TapHypotheses taps(5);
  const ExpectedTap uncut = bar(9000);
  taps.hear(lines_at({7150, 9180, 10130}), uncut);
  ExpectedTap cut = bar(9020);
  cut.cents += Eigen::Vector3d(40, 0, 10);
  cut.spread << 0, 0, 5, 5, 5;
  taps.hear(lines_at({7190, 10140}), cut);
  const TapHypothesis& best = taps.all().front();
  ASSERT_EQ(best.lines, (Lines{0, std::nullopt, 1}));
  ASSERT_TRUE(best.heard[1]);
  EXPECT_EQ(best.heard[1]->tap, 0U);
  EXPECT_NEAR(1200 * std::log2(best.heard[1]->frequency), 9180, 1e-9);
  EXPECT_EQ(best.heard[2]->tap, 1U);
  const Pitch pitch = best.pitch_of(1, cut);
  EXPECT_NEAR(pitch.cents, 9200, 0.2);
  EXPECT_NEAR(pitch.deviation, std::hypot(5, 1), 0.1);
  // What a line says of its mode is not more exact than the line, but hardly less.
  EXPECT_NEAR(best.pitch_of(2, cut).cents, 10140, 0.2);
  EXPECT_NEAR(best.pitch_of(2, cut).deviation, 1, 0.05);
}

// A cut moved both bending modes by 10 cents more than asked, five standard deviations. That they are missing, and that
// two other lines are where a deeper cut puts them, is less likely.
TEST(TapHypotheses, TakeASurpriseWhereLinesAgree) {
  TapHypotheses taps(5);
  taps.hear(lines_at({7000, 9000, 10000}), bar(9000));
  ExpectedTap cut = bar(9000);
  cut.spread << 0, 2, 0, 0, 0;
  cut.heard = {0.95, 0.95, 0.95};
  taps.hear(lines_at({6990, 9000, 9990}), cut);
  const TapHypothesis& best = taps.all().front();
  EXPECT_EQ(best.lines, (Lines{0, 1, 2}));
  EXPECT_LT(best.surprises[0], -3);
  EXPECT_LT(std::abs(best.surprises[1]), 3);
  EXPECT_LT(std::abs(best.surprises[2]), 3) << "the first line has told it";
}

// The reference is the normal equations of all lines and of what was known before, by themselves.
TEST(TapHypotheses, HaveTheUnknownsOfLeastSquares) {
  const ExpectedTap expected = bar(9000, 20.0);
  TapHypotheses taps(5);
  taps.hear(lines_at({7150, 9180, 10130}, 2.0), expected);
  ASSERT_EQ(taps.all().front().lines, (Lines{0, 1, 2}));
  const Eigen::Vector3d off(150, 180, 130);
  Eigen::MatrixXd precision = expected.slopes.transpose() * expected.slopes / 4;
  precision.diagonal() += expected.spread.array().square().inverse().matrix();
  const Eigen::VectorXd unknowns = precision.inverse() * expected.slopes.transpose() * off / 4;
  EXPECT_NEAR((taps.all().front().unknowns - unknowns).norm(), 0, 1e-6);
  EXPECT_NEAR((taps.all().front().covariance - Eigen::MatrixXd(precision.inverse())).norm(), 0, 1e-5);
}

// Random bars: where the bench is sure, it is right.
TEST(TapHypotheses, AreRightWhereTheyAreSure) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int sure = 0, wrong = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const ExpectedTap expected = bar(9900 + 300 * normal(random));
    const Eigen::VectorXd truth =
        expected.spread.cwiseProduct(Eigen::VectorXd::NullaryExpr(5, [&] { return normal(random); }));
    const Eigen::Vector3d cents = expected.cents + expected.slopes * truth;
    std::vector<double> heard = {cents[0] + normal(random), cents[1] + normal(random), cents[2] + normal(random)};
    const double bending = heard[2];
    std::ranges::sort(heard);
    const auto lines = lines_at(heard);
    TapHypotheses taps(5);
    taps.hear(lines, expected);
    const std::array<std::size_t, 2> modes = {0, 2};
    if (certainness_of(taps, modes, lines).probability > 0.99) {
      ++sure;
      const auto line = taps.all().front().lines[2];
      wrong += !line || std::abs(heard[*line] - bending) > 1.0;
    }
  }
  EXPECT_GT(sure, 400);
  EXPECT_LE(wrong, sure / 100);
}

}  // namespace
}  // namespace idiophone::bench
