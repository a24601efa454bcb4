#pragma once
// Gauss-Lobatto-Legendre (GLL) quadrature and Lagrange interpolation at its nodes, on [-1, 1].

#include <Eigen/Core>

namespace idiophone::element {

inline constexpr int highest_lobatto_order = 10;

/// The rule with order + 1 nodes, exact for polynomials of degree 2 order - 1.
struct Lobatto {
  Eigen::VectorXd nodes;    ///< [order + 1] ascending from -1 to 1: the zeros of (1 - x^2) P'(x), P of degree `order`
  Eigen::VectorXd weights;  ///< [order + 1] 2/(order (order + 1) P(x)^2); their sum is 2
  Eigen::MatrixXd derivative;  ///< [order + 1 x order + 1] dl_j/dx at node i, l_j the Lagrange polynomial of node j
};

/// @param order  1 to highest_lobatto_order
/// @throws std::invalid_argument for another order
[[nodiscard]] const Lobatto& lobatto(int order);

}  // namespace idiophone::element
