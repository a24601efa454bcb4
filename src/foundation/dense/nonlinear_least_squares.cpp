#include "idiophone/foundation/dense/nonlinear_least_squares.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

namespace idiophone::dense {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double first_damping = 1e-3;
constexpr double smallest_damping = 1e-12;
constexpr double largest_damping = 1e12;
constexpr double relaxation = 0.2;  // of the damping after a good step
constexpr double tightening = 5.0;  // after a bad one

VectorXd clamped(const VectorXd& point, const Box& box) {
  return point.cwiseMax(box.lower).cwiseMin(box.upper);
}

/// The damped Gauss-Newton step. Unknowns at a bound that the sum of squares falls beyond stay there.
VectorXd damped_step(const LeastSquares& now, const Box& box, double damping) {
  const VectorXd descent = -now.jacobian.transpose() * now.residuals;
  MatrixXd normal = now.jacobian.transpose() * now.jacobian;
  const double scale = std::max(normal.diagonal().maxCoeff(), 1e-300);
  normal.diagonal() += damping * (normal.diagonal().array() + 1e-6 * scale).matrix();
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

}  // namespace

LeastSquares minimize(const Residuals& residuals, const Jacobian& jacobian, const VectorXd& start, const Box& box,
                      const StopRule& stop) {
  const auto first = residuals(start);
  if (!first) {
    throw std::invalid_argument("least squares: the start is not allowed");
  }
  LeastSquares now{start, *first, jacobian(start), 0};
  double damping = first_damping;
  for (; now.iterations < stop.iterations; ++now.iterations) {
    if (now.residuals.lpNorm<Eigen::Infinity>() <= stop.residual) {
      break;
    }
    const VectorXd step = damped_step(now, box, damping);
    if (step.lpNorm<Eigen::Infinity>() <= stop.step) {
      break;
    }
    const VectorXd next = now.point + step;
    const auto there = residuals(next);
    const double before = now.residuals.squaredNorm(), after = there ? there->squaredNorm() : before;
    if (after < before) {
      now = {next, *there, jacobian(next), now.iterations};
      damping = std::max(relaxation * damping, smallest_damping);
      if (before - after < stop.reduction * before) {
        ++now.iterations;
        break;
      }
    } else {
      damping = std::min(tightening * damping, largest_damping);
    }
  }
  return now;
}

}  // namespace idiophone::dense
