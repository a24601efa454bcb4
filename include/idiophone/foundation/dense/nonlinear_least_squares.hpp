#pragma once
// Nonlinear least squares in a box: Gauss-Newton with Levenberg's damping (Marquardt 1963), steps cut at the bounds.
// The damping weighs each unknown by its largest slope so far (More 1978) and follows the gain of each step (Nielsen
// 1999).

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace idiophone::dense {

/// Residuals at a point; none where the point is not allowed.
using Residuals = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& point)>;
/// [residuals x unknowns] derivatives at an allowed point, which the search has just accepted.
using Jacobian = std::function<Eigen::MatrixXd(const Eigen::VectorXd& point)>;

struct Box {
  Eigen::VectorXd lower, upper;  ///< may be infinite
};

struct LeastSquaresOptions {
  double residual = 0.0;        ///< stop when no residual is larger
  double step = 1e-10;          ///< or when no unknown would change by more
  int iterations = 50;          ///< at most
  double first_damping = 1e-3;  ///< about 1 where the model is far from linear at the start
};

struct LeastSquares {
  Eigen::VectorXd point;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< at the point
  int iterations = 0;        ///< that it took
};

/// A local minimum of the sum of squared residuals.
/// @param start  an allowed point in the box
/// @throws std::invalid_argument if the start is not allowed
[[nodiscard]] LeastSquares minimize(const Residuals& residuals, const Jacobian& jacobian, const Eigen::VectorXd& start,
                                    const Box& box, const LeastSquaresOptions& options);

}  // namespace idiophone::dense
