#pragma once
// The rows of the spectral hexahedra in the table of reference elements. The reference cube is -1 <= xi <= 1. Node
// (i, j, k) stands at the i-th, j-th and k-th Gauss-Lobatto-Legendre node of xi_1, xi_2 and xi_3, and is number
// i + (p + 1) (j + (p + 1) k), p the order in the plane. The quadrature points are the nodes.

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::element {

/// The row of a hexahedron. The reference stays valid.
[[nodiscard]] const ReferenceElement& hexahedron(Type type);

/// gmsh's place of each node of a hexahedron of the same order in all directions (GmshElement::nodes). gmsh numbers
/// corners, then nodes within the edges, within the faces, and inside.
[[nodiscard]] std::vector<int> gmsh_hexahedron_nodes(int order);

/// N_a at any point. [nodes]
[[nodiscard]] Eigen::VectorXd hexahedron_functions(Type type, const Vector3& xi);

/// dN_a/dxi_k at any point. [nodes x 3]
[[nodiscard]] Eigen::MatrixX3d hexahedron_gradients(Type type, const Vector3& xi);

}  // namespace idiophone::element
