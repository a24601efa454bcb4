#include "nonnegative.hpp"

#include <Eigen/QR>
#include <vector>

namespace idiophone::bench {

namespace {

/// Least squares with some columns alone.
Eigen::VectorXd solution_of(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const std::vector<Eigen::Index>& used) {
  Eigen::MatrixXd columns(a.rows(), static_cast<Eigen::Index>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i) {
    columns.col(static_cast<Eigen::Index>(i)) = a.col(used[i]);
  }
  return columns.colPivHouseholderQr().solve(b);
}

/// Goes from x towards the solution with the used columns, as far as no number becomes negative, and takes those that
/// became 0 out of use. @return whether all of the way was possible
bool go_towards(const Eigen::VectorXd& solution, std::vector<Eigen::Index>& used, Eigen::VectorXd& x) {
  double way = 1.0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const double from = x[used[i]], to = solution[static_cast<Eigen::Index>(i)];
    if (to <= 0) {
      way = std::min(way, from / (from - to));
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    x[used[i]] += way * (solution[static_cast<Eigen::Index>(i)] - x[used[i]]);
  }
  if (way == 1.0) {
    return true;
  }
  const double nothing = 1e-14 * x.maxCoeff();
  std::erase_if(used, [&](Eigen::Index column) {
    const bool is_gone = x[column] <= nothing;
    x[column] = is_gone ? 0.0 : x[column];
    return is_gone;
  });
  return false;
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  constexpr double least_gain = 1e-9;  // cosine between a column and what is left
  const Eigen::VectorXd norms = a.colwise().norm().transpose();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  std::vector<Eigen::Index> used;
  const Eigen::Index most_steps = 3 * a.cols();
  for (Eigen::Index step = 0; step < most_steps; ++step) {
    const Eigen::VectorXd left = b - a * x;
    Eigen::VectorXd gain = (a.transpose() * left).cwiseQuotient(norms.cwiseMax(1e-300));
    for (const Eigen::Index column : used) {
      gain[column] = 0.0;
    }
    Eigen::Index best = 0;
    if (a.cols() == 0 || gain.maxCoeff(&best) <= least_gain * b.norm() || std::ssize(used) == a.rows()) {
      break;
    }
    used.push_back(best);
    while (!used.empty() && !go_towards(solution_of(a, b, used), used, x)) {
    }
  }
  return x;
}

}  // namespace idiophone::bench
