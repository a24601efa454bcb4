#include "idiophone/foundation/dense/nonlinear_least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace idiophone::dense {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

const double infinite = std::numeric_limits<double>::infinity();
const Box everywhere{Vector2d::Constant(-infinite), Vector2d::Constant(infinite)};

// Rosenbrock's valley: residuals 10 (y - x^2) and 1 - x.
std::optional<VectorXd> valley(const VectorXd& point) {
  return Vector2d(10 * (point[1] - point[0] * point[0]), 1 - point[0]);
}

MatrixXd valley_slopes(const VectorXd& point) {
  return (Eigen::Matrix2d() << -20 * point[0], 10, -1, 0).finished();
}

TEST(LeastSquares, FindsTheEndOfACurvedValley) {
  const LeastSquares found = minimize(valley, valley_slopes, Vector2d(-1.2, 1), everywhere, {});
  EXPECT_NEAR((found.point - Vector2d(1, 1)).norm(), 0, 1e-8);
  EXPECT_EQ(found.residuals, *valley(found.point));
  EXPECT_EQ(found.jacobian, valley_slopes(found.point));
}

TEST(LeastSquares, StaysInTheBox) {
  const Box box{Vector2d(-2, -2), Vector2d(0.5, 2)};
  const LeastSquares found = minimize(valley, valley_slopes, Vector2d(-1.2, 1), box, {});
  EXPECT_NEAR(found.point[0], 0.5, 1e-12);
  EXPECT_NEAR(found.point[1], 0.25, 1e-6);
}

TEST(LeastSquares, GoesAroundPointsThatAreNotAllowed) {
  const auto refusing = [](const VectorXd& point) { return point[1] < -0.1 ? std::nullopt : valley(point); };
  EXPECT_NEAR((minimize(refusing, valley_slopes, Vector2d(-1.2, 1), everywhere, {}).point - Vector2d(1, 1)).norm(), 0,
              1e-8);
  EXPECT_THROW(static_cast<void>(minimize(refusing, valley_slopes, Vector2d(0, -1), everywhere, {})),
               std::invalid_argument);
}

TEST(LeastSquares, StopsAtTheWantedResidual) {
  const LeastSquares found = minimize(valley, valley_slopes, Vector2d(-1.2, 1), everywhere, {.residual = 0.5});
  EXPECT_LE(found.residuals.lpNorm<Eigen::Infinity>(), 0.5);
  EXPECT_GT(found.residuals.norm(), 1e-3);
}

TEST(LeastSquares, StopsWhereAStepLowersTheSumByASmallPart) {
  // A residual that can't vanish: steps gain less and less of the sum.
  const auto raised = [](const VectorXd& point) -> std::optional<VectorXd> {
    return (VectorXd(3) << *valley(point), 1).finished();
  };
  const auto slopes = [](const VectorXd& point) -> MatrixXd {
    return (MatrixXd(3, 2) << valley_slopes(point), Eigen::RowVector2d::Zero()).finished();
  };
  const auto found_by = [&](const StopRule& stop) {
    return minimize(raised, slopes, Vector2d(-1.2, 1), everywhere, stop);
  };
  const LeastSquares whole = found_by({}), shorter = found_by({.reduction = 1e-4});
  EXPECT_LT(shorter.iterations, whole.iterations);
  EXPECT_NEAR((shorter.point - Vector2d(1, 1)).norm(), 0, 0.02);
  EXPECT_EQ(found_by({.iterations = 3}).iterations, 3);
}

TEST(LeastSquares, OneResidualAndTwoUnknowns) {
  const auto sum = [](const VectorXd& point) -> std::optional<VectorXd> {
    return VectorXd::Constant(1, point[0] + point[1] - 3);
  };
  const LeastSquares found =
      minimize(sum, [](const VectorXd&) { return MatrixXd(Eigen::RowVector2d(1, 1)); }, Vector2d(0, 0), everywhere, {});
  EXPECT_NEAR((found.point - Vector2d(1.5, 1.5)).norm(), 0, 1e-6) << "the smallest change";
}

}  // namespace
}  // namespace idiophone::dense
