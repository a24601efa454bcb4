#pragma once
// The element types: nodes, quadrature, and gradients of the shape functions in the reference tetrahedron
// xi_1, xi_2, xi_3 >= 0, xi_1 + xi_2 + xi_3 <= 1. One kernel serves them all (packed_elements.hpp).

#include <array>

namespace idiophone::solid {

/// A point of the reference tetrahedron: L_0 = 1 - xi_1 - xi_2 - xi_3, L_k = xi_k.
using Barycentric = std::array<double, 4>;

/// Linear tetrahedron, the paper's element. It locks in bending: its thin plates and bars sound far too high.
struct Tet4 {
  static constexpr int nodes = 4;
  static constexpr int points = 1;                      ///< quadrature points
  static constexpr double weight = 1.0 / 6.0;           ///< of each point; the reference tetrahedron has volume 1/6
  static constexpr double mass_share[2] = {0.25, 0.0};  ///< of a corner, of an edge node: row sum

  /// dN_node/dxi_direction at a quadrature point.
  static constexpr double gradient(int /*point*/, int node, int direction) {
    return node == 0 ? -1.0 : (node == direction + 1 ? 1.0 : 0.0);
  }

  /// N_node at any point.
  static constexpr double shape_at(const Barycentric& place, int node) { return place[static_cast<std::size_t>(node)]; }

  /// dN_node/dxi_direction at any point.
  static constexpr double gradient_at(const Barycentric& /*place*/, int node, int direction) {
    return gradient(0, node, direction);
  }

  /// Derivatives of a nodal field along xi_1, xi_2, xi_3 at each quadrature point.
  template <class Number>
  static void differentiate(const Number (&field)[nodes], Number (&slope)[points][3]) {
    for (int k = 0; k < 3; ++k) {
      slope[0][k] = field[k + 1] - field[0];
    }
  }

  /// The transpose of `differentiate`: nodal_a = sum over points and directions of flux times dN_a/dxi.
  template <class Number>
  static void assemble(const Number (&flux)[points][3], Number (&nodal)[nodes]) {
    nodal[0] = -(flux[0][0] + flux[0][1] + flux[0][2]);
    for (int k = 0; k < 3; ++k) {
      nodal[k + 1] = flux[0][k];
    }
  }
};

/// Quadratic tetrahedron with four Gauss points; nodes are the corners 0 1 2 3, then edges 01, 12, 02, 03, 13, 23.
struct Tet10 {
  static constexpr int nodes = 10;
  static constexpr int points = 4;
  static constexpr double weight = 1.0 / 24.0;
  /// Diagonal scaling (Hinton, Rock and Zienkiewicz 1976): the consistent mass's diagonal, scaled to the element's
  /// mass.
  static constexpr double mass_share[2] = {1.0 / 36.0, 4.0 / 27.0};

  static constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

  static constexpr double gradient(int point, int node, int direction) {
    Barycentric place = {far, far, far, far};
    place[static_cast<std::size_t>(point)] = near;
    return gradient_at(place, node, direction);
  }

  /// As Tet4's.
  static constexpr double shape_at(const Barycentric& place, int node) {
    if (node < 4) {
      const double l = place[static_cast<std::size_t>(node)];
      return l * (2.0 * l - 1.0);
    }
    const auto [i, j] = edges[static_cast<std::size_t>(node - 4)];
    return 4.0 * place[static_cast<std::size_t>(i)] * place[static_cast<std::size_t>(j)];
  }

  /// As Tet4's.
  static constexpr double gradient_at(const Barycentric& place, int node, int direction) {
    if (node < 4) {
      return (4.0 * place[static_cast<std::size_t>(node)] - 1.0) * slope(node, direction);
    }
    const auto [i, j] = edges[static_cast<std::size_t>(node - 4)];
    return 4.0 * (place[static_cast<std::size_t>(i)] * slope(j, direction) +
                  place[static_cast<std::size_t>(j)] * slope(i, direction));
  }

  /// As Tet4's. Along edge 0k of the tetrahedron the derivative is 4 sum_c L_c d_c - (f_k - f_0), with L_c the
  /// barycentric coordinates and d_c the difference of the two nodes half an edge apart that point from corner c along
  /// the edge's direction. At Gauss point q all L_c are `far` but L_q, so four points cost little more than one.
  template <class Number>
  static void differentiate(const Number (&field)[nodes], Number (&slope)[points][3]) {
    for (int k = 0; k < 3; ++k) {
      Number difference[4];
      Number sum = {};
      for (int c = 0; c < 4; ++c) {
        difference[c] = field[parallel[k][c][1]] - field[parallel[k][c][0]];
        sum += difference[c];
      }
      const Number common = 4.0 * far * sum - (field[k + 1] - field[0]);
      for (int q = 0; q < points; ++q) {
        slope[q][k] = common + 4.0 * (near - far) * difference[q];
      }
    }
  }

  /// As Tet4's.
  template <class Number>
  static void assemble(const Number (&flux)[points][3], Number (&nodal)[nodes]) {
    for (Number& value : nodal) {
      value = Number{};
    }
    for (int k = 0; k < 3; ++k) {
      const Number sum = flux[0][k] + flux[1][k] + flux[2][k] + flux[3][k];
      for (int c = 0; c < 4; ++c) {
        const Number pull = 4.0 * far * sum + 4.0 * (near - far) * flux[c][k];
        nodal[parallel[k][c][1]] += pull;
        nodal[parallel[k][c][0]] -= pull;
      }
      nodal[k + 1] -= sum;
      nodal[0] += sum;
    }
  }

 private:
  /// Barycentric coordinate of a Gauss point's own corner, (5 + 3 sqrt 5)/20, and of the others, (5 - sqrt 5)/20.
  static constexpr double near = 0.58541019662496845446;
  static constexpr double far = 0.13819660112501051518;

  /// The half edge parallel to edge 0-(k+1) that belongs to corner c: from which node to which, [k][c].
  static constexpr int parallel[3][4][2] = {
      {{0, 4}, {4, 1}, {6, 5}, {7, 8}}, {{0, 6}, {4, 5}, {6, 2}, {7, 9}}, {{0, 7}, {4, 8}, {6, 9}, {7, 3}}};

  static constexpr double slope(int corner, int direction) { return Tet4::gradient(0, corner, direction); }
};

}  // namespace idiophone::solid
