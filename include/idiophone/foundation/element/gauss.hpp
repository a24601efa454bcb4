#pragma once
// Gauss and Legendre's quadrature on [0, 1].

#include <Eigen/Core>

namespace idiophone::element {

/// The rule of n points, exact for polynomials of degree 2 n - 1.
struct Gauss {
  Eigen::VectorXd places;   ///< [points] ascending
  Eigen::VectorXd weights;  ///< [points] their sum is 1
};

/// @param points  at least 1
[[nodiscard]] Gauss gauss(int points);

}  // namespace idiophone::element
