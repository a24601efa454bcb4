#include "idiophone/foundation/dense/nonlinear_least_squares.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace idiophone::dense {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double smallest_damping = 1e-12;
constexpr double largest_damping = 1e12;
constexpr double first_growth = 2.0;  // of the damping after a bad step
constexpr double least_gain = 1e-4;   // of a good one

VectorXd clamped(const VectorXd& point, const Box& box) {
  return point.cwiseMax(box.lower).cwiseMin(box.upper);
}

/// The damped Gauss-Newton step. Unknowns at a bound that the sum of squares falls beyond stay there.
/// @param weights  [unknowns] of the squares of a step that are damped
VectorXd damped_step(const LeastSquares& now, const Box& box, const VectorXd& weights, double damping) {
  const VectorXd descent = -now.jacobian.transpose() * now.residuals;
  MatrixXd normal = now.jacobian.transpose() * now.jacobian;
  const double scale = std::max(normal.diagonal().maxCoeff(), 1e-300);
  normal.diagonal() += damping * (weights.array() + 1e-12 * scale).matrix();
  VectorXd right = descent;
  for (Eigen::Index i = 0; i < right.size(); ++i) {
    const bool held =
        (now.point[i] <= box.lower[i] && descent[i] < 0) || (now.point[i] >= box.upper[i] && descent[i] > 0);
    if (held) {
      normal.row(i).setZero();
      normal.col(i).setZero();
      normal(i, i) = 1.0;
      right[i] = 0.0;
    }
  }
  return clamped(now.point + normal.ldlt().solve(right), box) - now.point;
}

/// By how much a step makes the sum of squares less, over what the linear model expects.
double gain_of(const LeastSquares& now, const VectorXd& step, const VectorXd& there) {
  const double before = now.residuals.squaredNorm();
  return (before - there.squaredNorm()) / (before - (now.residuals + now.jacobian * step).squaredNorm());
}

}  // namespace

LeastSquares minimize(const Residuals& residuals, const Jacobian& jacobian, const VectorXd& start, const Box& box,
                      const LeastSquaresOptions& options) {
  const auto first = residuals(start);
  if (!first) {
    throw std::invalid_argument("least squares: the start is not allowed");
  }
  LeastSquares now{start, *first, jacobian(start)};
  double damping = options.first_damping;
  double growth = first_growth;
  VectorXd weights = now.jacobian.colwise().squaredNorm();
  for (; now.iterations < options.iterations; ++now.iterations) {
    if (now.residuals.lpNorm<Eigen::Infinity>() <= options.residual) {
      break;
    }
    const VectorXd step = damped_step(now, box, weights, damping);
    if (step.lpNorm<Eigen::Infinity>() <= options.step) {
      break;
    }
    const VectorXd next = now.point + step;
    const auto there = residuals(next);
    const double gain = there ? gain_of(now, step, *there) : 0.0;
    if (gain > least_gain) {
      now = {next, *there, jacobian(next), now.iterations};
      weights = weights.cwiseMax(now.jacobian.colwise().squaredNorm().transpose());
      damping *= std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3));
      growth = first_growth;
    } else {
      damping *= growth;
      growth *= 2;
    }
    damping = std::clamp(damping, smallest_damping, largest_damping);
  }
  return now;
}

}  // namespace idiophone::dense
