#pragma once
// Least squares whose unknowns are not negative.

#include <Eigen/Core>

namespace idiophone::bench {

/// The x >= 0 that makes |a x - b| least, by the active sets of Lawson and Hanson (1974). No more of its numbers than
/// `a` has rows are above 0.
[[nodiscard]] Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace idiophone::bench
