#pragma once
// Nonlinear least squares in a box: Gauss-Newton with Levenberg's damping (Marquardt 1963), steps cut at the bounds.

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

struct StopRule {
  double residual = 0.0;   ///< stop when no residual is larger
  double step = 1e-10;     ///< or when no unknown would change by more
  double reduction = 0.0;  ///< or when a step lowers the sum of squares by a smaller part of it
  int iterations = 50;     ///< at most
};

struct LeastSquares {
  Eigen::VectorXd point;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< at the point
  int iterations = 0;        ///< each solves a system of [unknowns x unknowns]
};

/// A local minimum of the sum of squared residuals.
/// @param start  an allowed point in the box
/// @throws std::invalid_argument if the start is not allowed
[[nodiscard]] LeastSquares minimize(const Residuals& residuals, const Jacobian& jacobian, const Eigen::VectorXd& start,
                                    const Box& box, const StopRule& stop);

}  // namespace idiophone::dense
