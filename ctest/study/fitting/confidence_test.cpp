#include "confidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Lines that all depend on two constants in the same way, by 100 and 50 of their uncertainties.
Evidence lines_of_two_constants(Eigen::Index count, double mesh_error) {
  return {VectorXd::Zero(count), MatrixXd(VectorXd::Ones(count) * Eigen::RowVector2d(100, 50)),
          VectorXd::Constant(count, mesh_error)};
}

VectorXd half_widths(const Evidence& evidence, const Expectation& expected, const MatrixXd& value_slopes) {
  return fitting::half_widths(evidence, residual_spread(evidence, expected), expected, value_slopes);
}

const MatrixXd of_unknowns = MatrixXd::Identity(2, 2);
const Expectation one_is_known_within_a_fifth{Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 0.2)};

ON_RANKS(1);

// However many lines there are, the first constant is off by half of what the second one is off.
TEST(Confidence, ContainsTheConstantsThatTheLinesDoNotShow) {
  const VectorXd widths = half_widths(lines_of_two_constants(1000, 0), one_is_known_within_a_fifth, of_unknowns);
  EXPECT_NEAR(widths[1] / (1.96 * 0.2), 1, 0.02);
  EXPECT_NEAR(widths[0] / (1.96 * 0.1), 1, 0.02);
}

// The mesh makes all modes too high, so many lines do not help.
TEST(Confidence, ContainsTheErrorOfTheMesh) {
  const Expectation second_is_known{Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 1e-9)};
  const double without = half_widths(lines_of_two_constants(1000, 0), second_is_known, of_unknowns)[0];
  const double with = half_widths(lines_of_two_constants(1000, 2), second_is_known, of_unknowns)[0];
  EXPECT_NEAR(without / (1.96 / 100 / std::sqrt(1000)), 1, 0.02);
  EXPECT_NEAR(with / (1.96 * 2 / 100), 1, 0.02);
}

TEST(Confidence, GrowsWithResidualsAboveTheUncertainties) {
  Evidence evidence = lines_of_two_constants(1000, 0);
  const double before = half_widths(evidence, {Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 1e-9)}, of_unknowns)[0];
  evidence.residuals.setConstant(3.0);
  const double after = half_widths(evidence, {Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 1e-9)}, of_unknowns)[0];
  EXPECT_NEAR(after / before, 3, 0.01);
}

// Ten lines of one constant whose errors are as large as their uncertainties say, many times. In one fit of 20, the
// residuals are larger than usual, and the interval is wider.
TEST(Confidence, IntervalsHoldTheTruthInNinetyFiveOfAHundredFits) {
  constexpr int fits = 4000;
  const VectorXd slopes = VectorXd::LinSpaced(10, 20, 110);
  const Expectation vague{VectorXd::Zero(1), VectorXd::Constant(1, 10)};
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  int inside = 0;
  for (int fit = 0; fit < fits; ++fit) {
    const VectorXd errors = VectorXd::NullaryExpr(slopes.size(), [&] { return normal(generator); });
    const double found = slopes.dot(errors) / slopes.squaredNorm();
    const Evidence evidence{errors - slopes * found, slopes, VectorXd::Zero(slopes.size())};
    inside += std::abs(found) <= half_widths(evidence, vague, MatrixXd::Ones(1, 1))[0] ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(inside) / fits, 0.95, 0.01);
}

TEST(Confidence, KnowsWhatIsChance) {
  EXPECT_NEAR(largest_by_chance(1) / 3.8415, 1, 0.04);
  EXPECT_NEAR(largest_by_chance(10) / 1.8307, 1, 1e-3);
  EXPECT_NEAR(largest_by_chance(100) / 1.24342, 1, 1e-4);
  EXPECT_NEAR(largest_believable(1) / 10.828, 1, 0.04);
  EXPECT_NEAR(largest_believable(10) / 29.588, 1, 0.01);
  EXPECT_NEAR(largest_believable(100) / 149.449, 1, 1e-3);
}

// A line whose mode does not depend on the constant, beside lines that fit badly.
TEST(Confidence, ALineThatSaysNothingChangesNoInterval) {
  Evidence evidence = lines_of_two_constants(3, 0);
  evidence.residuals.setConstant(3.0);
  const Expectation second_is_known{Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 1e-9)};
  const ResidualSpread residuals = residual_spread(evidence, second_is_known);
  const double before = fitting::half_widths(evidence, residuals, second_is_known, of_unknowns)[0];
  const Evidence more{(VectorXd(4) << evidence.residuals, 0).finished(),
                      (MatrixXd(4, 2) << evidence.slopes, 0, 0).finished(), VectorXd::Zero(4)};
  EXPECT_DOUBLE_EQ(fitting::half_widths(more, residuals, second_is_known, of_unknowns)[0], before);
  EXPECT_LT(half_widths(more, second_is_known, of_unknowns)[0], 0.7 * before) << "as if it had been measured";
}

// Of a value that the lines show alone, the interval is small although those of both constants are wide.
TEST(Confidence, OfAValueThatDependsOnTwoConstants) {
  const Expectation vague{Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)};
  const Evidence evidence = lines_of_two_constants(1000, 0);
  const double of_sum = half_widths(evidence, vague, Eigen::RowVector2d(100, 50))[0];
  EXPECT_NEAR(of_sum / (1.96 / std::sqrt(1000)), 1, 0.02);
  EXPECT_GT(half_widths(evidence, vague, of_unknowns)[0], 1);
}

}  // namespace
}  // namespace idiophone::fitting
