#pragma once
// How well a fit determines its unknowns.

#include <Eigen/Core>

namespace idiophone::fitting {

/// Half-widths of the 95 % confidence intervals of the unknowns of a weighted fit: Student's t times the root of the
/// diagonal of s^2 (J^T J)^-1, where s^2 is the mean square of the residuals per degree of freedom, and at least 1, as
/// the lines are not better than their uncertainties. Directions that no residual depends on count as infinitely wide.
/// @param residuals  over their uncertainties
/// @param jacobian   of these, [residuals x unknowns]
[[nodiscard]] Eigen::VectorXd half_widths(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian);

}  // namespace idiophone::fitting
