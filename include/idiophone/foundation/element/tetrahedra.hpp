#pragma once
// The tables of the tetrahedra, as constants for kernels. Code that needs no constants uses reference.hpp.
//
// The reference tetrahedron is xi_1, xi_2, xi_3 >= 0, xi_1 + xi_2 + xi_3 <= 1. Nodes are the corners 0 1 2 3, then the
// middles of the edges 01, 12, 02, 03, 13, 23.

#include <array>

namespace idiophone::element {

/// A point of the reference tetrahedron: L_0 = 1 - xi_1 - xi_2 - xi_3, L_k = xi_k.
using Barycentric = std::array<double, 4>;

/// The corners at the ends of each edge. Edge e of a quadratic tetrahedron has its middle at node 4 + e.
inline constexpr std::array<std::array<int, 2>, 6> tetrahedron_edges = {
    {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

/// Each face's three corners, counter-clockwise as seen from outside, then the middles of its edges from the first
/// corner to the second, the second to the third, and the third to the first.
inline constexpr std::array<std::array<int, 6>, 4> tetrahedron_faces = {
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}}};

/// dL_corner/dxi_direction
[[nodiscard]] constexpr double barycentric_slope(int corner, int direction) {
  return corner == 0 ? -1.0 : (corner == direction + 1 ? 1.0 : 0.0);
}

/// Linear tetrahedron. It locks in bending: its thin plates and bars sound far too high.
struct Tet4 {
  static constexpr int nodes = 4;
  static constexpr int points = 1;                                                         ///< quadrature points
  static constexpr std::array<Barycentric, points> places = {{{0.25, 0.25, 0.25, 0.25}}};  ///< of quadrature points
  static constexpr std::array<double, points> weights = {1.0 / 6};  ///< the reference tetrahedron has volume 1/6
  static constexpr std::array<double, nodes> mass_shares = {0.25, 0.25, 0.25, 0.25};  ///< of the lumped mass: row sums

  static constexpr std::array<std::array<int, 3>, 1> face_triangles = {{{0, 1, 2}}};  ///< places in a face
  static constexpr std::array<std::array<int, 4>, 1> straight_tetrahedra = {{{0, 1, 2, 3}}};
  static constexpr std::array<int, nodes> gmsh_nodes = {0, 1, 2, 3};  ///< gmsh's number of each node

  /// N_node
  static constexpr double shape(const Barycentric& place, int node) { return place[node]; }

  /// dN_node/dxi_direction
  static constexpr double gradient(const Barycentric& /*place*/, int node, int direction) {
    return barycentric_slope(node, direction);
  }
};

/// Quadratic tetrahedron with four Gauss points.
struct Tet10 {
  /// Barycentric coordinate of a Gauss point's own corner, (5 + 3 sqrt 5)/20, and of the others, (5 - sqrt 5)/20.
  static constexpr double near = 0.58541019662496845446;
  static constexpr double far = 0.13819660112501051518;

  static constexpr int nodes = 10;
  static constexpr int points = 4;
  static constexpr std::array<Barycentric, points> places = {
      {{near, far, far, far}, {far, near, far, far}, {far, far, near, far}, {far, far, far, near}}};
  static constexpr std::array<double, points> weights = {1.0 / 24, 1.0 / 24, 1.0 / 24, 1.0 / 24};
  /// Diagonal scaling (Hinton, Rock and Zienkiewicz 1976): the consistent mass's diagonal, scaled to the element's
  /// mass.
  static constexpr std::array<double, nodes> mass_shares = {1.0 / 36, 1.0 / 36, 1.0 / 36, 1.0 / 36, 4.0 / 27,
                                                            4.0 / 27, 4.0 / 27, 4.0 / 27, 4.0 / 27, 4.0 / 27};

  static constexpr std::array<std::array<int, 3>, 4> face_triangles = {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
  /// The four corners, and the octahedron between them cut along one diagonal.
  static constexpr std::array<std::array<int, 4>, 8> straight_tetrahedra = {
      {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}, {4, 8, 6, 7}, {4, 5, 6, 8}, {9, 8, 7, 6}, {9, 5, 8, 6}}};
  static constexpr std::array<int, nodes> gmsh_nodes = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};  ///< edge 23 before edge 13

  /// N_node
  static constexpr double shape(const Barycentric& place, int node) {
    if (node < 4) {
      return place[node] * (2.0 * place[node] - 1.0);
    }
    const auto [i, j] = tetrahedron_edges[node - 4];
    return 4.0 * place[i] * place[j];
  }

  /// dN_node/dxi_direction
  static constexpr double gradient(const Barycentric& place, int node, int direction) {
    if (node < 4) {
      return (4.0 * place[node] - 1.0) * barycentric_slope(node, direction);
    }
    const auto [i, j] = tetrahedron_edges[node - 4];
    return 4.0 * (place[i] * barycentric_slope(j, direction) + place[j] * barycentric_slope(i, direction));
  }
};

}  // namespace idiophone::element
