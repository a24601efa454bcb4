#pragma once
// Lagrange interpolation between nodes on a line.

#include <Eigen/Core>

namespace idiophone::element {

/// The polynomials l_a that are 1 at node a and 0 at the others, at one point.
struct Lagrange {
  Eigen::VectorXd values;  ///< [nodes] l_a
  Eigen::VectorXd slopes;  ///< [nodes] dl_a/dx
};

/// @param nodes  all different
[[nodiscard]] Lagrange lagrange(const Eigen::VectorXd& nodes, double x);

/// The order + 1 nodes that gmsh's elements have along a line, on [-1, 1].
[[nodiscard]] Eigen::VectorXd evenly_spaced_nodes(int order);

}  // namespace idiophone::element
