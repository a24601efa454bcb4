#include "confidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::fitting {

namespace {

/// Student's t that 97.5 % are below; Abramowitz and Stegun, 26.7.5. Within 3 % from 2 degrees of freedom on.
double student_t(double freedom) {
  constexpr double z = 1.959964;
  const double z2 = z * z;
  return z * (1 + (z2 + 1) / (4 * freedom) + ((5 * z2 + 16) * z2 + 3) / (96 * freedom * freedom) +
              (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * freedom * freedom * freedom));
}

}  // namespace

Eigen::VectorXd half_widths(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian) {
  const double freedom = std::max(1.0, static_cast<double>(jacobian.rows() - jacobian.cols()));
  const double variance = std::max(1.0, residuals.squaredNorm() / freedom);
  const auto [values, vectors] = dense::eigenpairs(Eigen::MatrixXd(jacobian.transpose() * jacobian));
  const double negligible = 1e-14 * values.maxCoeff();
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(jacobian.cols());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Eigen::ArrayXd shares = vectors.col(i).array().square();
    const double width = values[i] > negligible ? variance / values[i] : std::numeric_limits<double>::infinity();
    squares.array() += (shares > 1e-12).select(shares * width, 0.0);
  }
  return student_t(freedom) * squares.cwiseSqrt();
}

}  // namespace idiophone::fitting
