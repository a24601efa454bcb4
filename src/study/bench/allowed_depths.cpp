#include "allowed_depths.hpp"

#include "nonnegative.hpp"

namespace idiophone::bench {

Eigen::VectorXd allowed_depths(Eigen::MatrixXd slopes, Eigen::VectorXd goal, double deepest, const Overlap& overlap) {
  constexpr int most_rounds = 6;
  Eigen::VectorXd depths = Eigen::VectorXd::Zero(slopes.cols());
  for (int round = 0; round < most_rounds; ++round) {
    const Eigen::VectorXd more = nonnegative_least_squares(slopes, goal);
    if (more.size() == 0 || more.maxCoeff() <= deepest) {
      return depths + more;
    }
    for (Eigen::Index c = 0; c < more.size(); ++c) {
      if (more[c] <= deepest || depths[c] > 0) {
        continue;
      }
      depths[c] = deepest;
      goal -= deepest * slopes.col(c);
      for (Eigen::Index other = 0; other < slopes.cols(); ++other) {
        if (overlap(c, other)) {
          slopes.col(other).setZero();  // it is out of the choice
        }
      }
    }
  }
  return depths;
}

}  // namespace idiophone::bench
