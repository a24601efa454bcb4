#include "quartimax.hpp"

#include <cmath>

namespace idiophone::eigenmodes {

namespace {

/// The angle in the plane of two directions that makes the sum of fourth powers largest.
double best_angle(const Eigen::Ref<const Eigen::ArrayXd>& one, const Eigen::Ref<const Eigen::ArrayXd>& other) {
  double of_difference = 0.0, of_product = 0.0, of_both = 0.0;
  for (Eigen::Index i = 0; i < one.size(); ++i) {
    const double difference = one[i] * one[i] - other[i] * other[i];
    const double product = 2 * one[i] * other[i];
    of_difference += difference * difference;
    of_product += product * product;
    of_both += difference * product;
  }
  return std::atan2(2 * of_both, of_difference - of_product) / 4;
}

void turn(Eigen::MatrixXd& columns, Eigen::Index one, Eigen::Index other, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const double first = columns(i, one), second = columns(i, other);
    columns(i, one) = c * first + s * second;
    columns(i, other) = c * second - s * first;
  }
}

}  // namespace

Eigen::MatrixXd quartimax(Eigen::MatrixXd directions, Eigen::MatrixXd seen) {
  constexpr double small = 1e-3;  // angle
  constexpr int most_sweeps = 4;  // two are nearly always enough
  bool goes_on = true;
  for (int sweep = 0; sweep < most_sweeps && goes_on; ++sweep) {
    goes_on = false;
    for (Eigen::Index one = 0; one < seen.cols(); ++one) {
      for (Eigen::Index other = one + 1; other < seen.cols(); ++other) {
        const double angle = best_angle(seen.col(one), seen.col(other));
        if (std::abs(angle) > small) {
          turn(seen, one, other, angle);
          turn(directions, one, other, angle);
          goes_on = true;
        }
      }
    }
  }
  return directions;
}

}  // namespace idiophone::eigenmodes
