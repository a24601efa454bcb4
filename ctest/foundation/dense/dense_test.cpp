#include "idiophone/foundation/dense/dense.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace idiophone::dense
