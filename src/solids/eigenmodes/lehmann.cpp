#include "lehmann.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::eigenmodes {

namespace {

/// The bounds with one shift, (rad/s)^2.
Eigen::VectorXd bounds_with(double shift, const Eigen::VectorXd& values, const StressDefects& defects,
                            double separation) {
  const Eigen::ArrayXd v = values.array() + shift;
  const double limit = separation + shift;
  const Eigen::VectorXd scale = limit / v;
  Eigen::MatrixXd matrix = scale.asDiagonal() * (defects.energy + defects.equation / shift) * scale.asDiagonal();
  matrix.diagonal().array() += (limit - v).square() / v;
  const Eigen::MatrixXd root = dense::inverse_root(matrix);
  const Eigen::VectorXd difference = v - limit;
  const Eigen::MatrixXd quotient = root * difference.asDiagonal() * root;
  const Eigen::ArrayXd ratios = dense::eigenpairs(quotient).values;
  return limit - limit / (1 - ratios) - shift;
}

}  // namespace

Eigen::VectorXd lower_bounds(const Eigen::VectorXd& values, const StressDefects& defects, double separation) {
  constexpr int steps_each_way = 8;  // of a factor of 10^(1/4)
  Eigen::VectorXd best = Eigen::VectorXd::Zero(values.size());
  for (int step = -steps_each_way; step <= steps_each_way; ++step) {
    Eigen::VectorXd bounds = bounds_with(separation * std::pow(10.0, 0.25 * step), values, defects, separation);
    std::ranges::sort(bounds);
    best = best.cwiseMax(bounds);
  }
  return best;
}

}  // namespace idiophone::eigenmodes
