#include "idiophone/foundation/element/lobatto.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace idiophone::element {
namespace {

class LobattoTest : public ::testing::TestWithParam<int> {
 protected:
  const Lobatto& rule = lobatto(GetParam());

  /// x^degree at the nodes.
  [[nodiscard]] Eigen::VectorXd power(int degree) const {
    return rule.nodes.unaryExpr([degree](double x) { return std::pow(x, degree); });
  }
};

TEST_P(LobattoTest, NodesRunFromEndToEndAndAreSymmetric) {
  EXPECT_EQ(rule.nodes[0], -1.0);
  for (Eigen::Index i = 0; i < rule.nodes.size(); ++i) {
    EXPECT_EQ(rule.nodes[i], -rule.nodes[rule.nodes.size() - 1 - i]);
    EXPECT_TRUE(i == 0 || rule.nodes[i] > rule.nodes[i - 1]);
  }
}

TEST_P(LobattoTest, IntegratesPolynomialsOfDegreeTwiceTheOrderMinusOneAndNoHigher) {
  for (int degree = 0; degree < 2 * GetParam(); ++degree) {
    const double exact = degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0;
    EXPECT_NEAR(rule.weights.dot(power(degree)), exact, 1e-14) << degree;
  }
  EXPECT_GT(std::abs(rule.weights.dot(power(2 * GetParam())) - 2.0 / (2 * GetParam() + 1)), 1e-6);
}

TEST_P(LobattoTest, DifferentiatesPolynomialsUpToItsOrder) {
  for (int degree = 0; degree <= GetParam(); ++degree) {
    const Eigen::VectorXd exact =
        degree == 0 ? Eigen::VectorXd::Zero(rule.nodes.size()).eval() : degree * power(degree - 1);
    EXPECT_LT((rule.derivative * power(degree) - exact).lpNorm<Eigen::Infinity>(), 1e-13) << degree;
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, LobattoTest, ::testing::Range(1, highest_lobatto_order + 1));

TEST(Lobatto, HasTheNodesOfTheTablesForOrderFour) {
  EXPECT_NEAR(lobatto(4).nodes[1], -std::sqrt(3.0 / 7), 1e-15);
  EXPECT_NEAR(lobatto(4).weights[1], 49.0 / 90, 1e-15);
  EXPECT_NEAR(lobatto(4).derivative(0, 0), -5.0, 1e-14);
}

TEST(Lobatto, RefusesOrdersItHasNoRuleFor) {
  EXPECT_THROW((void)lobatto(0), std::invalid_argument);
  EXPECT_THROW((void)lobatto(highest_lobatto_order + 1), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::element
