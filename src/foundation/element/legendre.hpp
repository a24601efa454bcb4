#pragma once
// Legendre's polynomials, whose zeros and extrema are the points of quadrature rules.

#include <utility>

namespace idiophone::element {

/// Legendre's polynomial of a degree, and its first derivative.
struct Legendre {
  double value;
  double slope;
};

[[nodiscard]] inline Legendre legendre(int degree, double x) {
  double before = 1.0;
  double value = x;
  double slope_before = 0.0;
  double slope = 1.0;
  for (int k = 2; k <= degree; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    const double next_slope = slope_before + (2 * k - 1) * value;
    before = std::exchange(value, next);
    slope_before = std::exchange(slope, next_slope);
  }
  return {value, slope};
}

}  // namespace idiophone::element
