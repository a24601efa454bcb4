#include "halton_point.hpp"

#include <array>

namespace idiophone::fitting {

namespace {

/// A number of the sequence of van der Corput: evenly spread between 0 and 1.
double van_der_corput(int number, int base) {
  double value = 0.0;
  double place = 1.0;
  for (; number > 0; number /= base) {
    place /= base;
    value += place * (number % base);
  }
  return value;
}

}  // namespace

Eigen::VectorXd halton_point(int number, Eigen::Index directions) {
  constexpr std::array bases = {2, 3, 5, 7, 11, 13, 17, 19};
  Eigen::VectorXd point(directions);
  for (Eigen::Index i = 0; i < directions; ++i) {
    point[i] = 0.05 + 0.9 * van_der_corput(number, bases.at(i % bases.size()));
  }
  return point;
}

}  // namespace idiophone::fitting
