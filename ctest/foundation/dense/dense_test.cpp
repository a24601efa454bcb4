#include "idiophone/foundation/dense/dense.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace idiophone::dense {
namespace {

/// The second differences of a chain of n masses, whose eigenvalues are 4 sin^2(k pi/(2 (n + 1))).
Eigen::MatrixXd chain(Eigen::Index n) {
  Eigen::MatrixXd matrix = 2.0 * Eigen::MatrixXd::Identity(n, n);
  matrix.diagonal(1).setConstant(-1.0);
  matrix.diagonal(-1).setConstant(-1.0);
  return matrix;
}

template <class Pairs>
void expect_chain(const Pairs& pairs, const Eigen::MatrixXd& matrix) {
  for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
    const double root =
        2.0 * std::sin(static_cast<double>(k + 1) * std::numbers::pi / (2.0 * static_cast<double>(matrix.rows() + 1)));
    EXPECT_NEAR(pairs.values[k], root * root, 1e-14);
    EXPECT_LT((matrix * pairs.vectors.col(k) - pairs.values[k] * pairs.vectors.col(k)).norm(), 1e-13);
  }
}

TEST(Dense, EigenvaluesOfAChainAreThoseOfTheory) {
  expect_chain(eigenpairs(chain(9)), chain(9));
  expect_chain(eigenpairs(Matrix6(chain(6))), chain(6));
}

TEST(Dense, TheInverseRootTwiceIsTheInverse) {
  const Eigen::MatrixXd root = inverse_root(chain(5));
  EXPECT_LT((root * root * chain(5) - Eigen::MatrixXd::Identity(5, 5)).norm(), 1e-13);
}

TEST(Dense, LeastSquaresLeavesARestThatIsOrthogonalToAllColumns) {
  Eigen::MatrixXd line(4, 2);
  line << 1, 0, 1, 1, 1, 2, 1, 3;
  const Eigen::Vector4d wanted(1, 3, 2, 5);
  const Eigen::VectorXd found = least_squares(line, wanted);
  EXPECT_LT((line.transpose() * (line * found - wanted)).norm(), 1e-13);
  EXPECT_NEAR(found[1], 1.1, 1e-14);
}

TEST(Dense, PrincipalAxesAreThoseOfATurnedBox) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()).matrix();
  std::vector<Eigen::Vector3d> corners;
  for (int corner = 0; corner < 8; ++corner) {
    corners.emplace_back(
        turn * Eigen::Vector3d((corner & 1) != 0 ? 1 : 5, (corner & 2) != 0 ? 1 : 2, (corner & 4) != 0 ? 9 : 0));
  }
  const Eigen::Matrix3d axes = principal_axes(corners);
  for (const auto& [axis, column] : {std::pair(1, 0), std::pair(0, 1), std::pair(2, 2)}) {
    EXPECT_NEAR(std::abs(axes.col(column).dot(turn.col(axis))), 1, 1e-14) << "edges of 4, 1 and 9 m";
  }
}

}  // namespace
}  // namespace idiophone::dense
