#include "idiophone/foundation/element/gauss.hpp"

#include <cmath>
#include <numbers>

#include "legendre.hpp"

namespace idiophone::element {

Gauss gauss(int points) {
  Gauss rule{Eigen::VectorXd(points), Eigen::VectorXd(points)};
  for (int i = 0; i < points; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));  // close enough for Newton's method
    for (int iteration = 0; iteration < 6; ++iteration) {
      const Legendre polynomial = legendre(points, x);
      x -= polynomial.value / polynomial.slope;
    }
    const double slope = legendre(points, x).slope;
    rule.places[i] = (1 + x) / 2;
    rule.weights[i] = 1 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace idiophone::element
