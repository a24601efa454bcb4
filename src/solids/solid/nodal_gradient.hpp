#pragma once
// Gradients of nodal fields at the quadrature points of tetrahedra, and the transposed operation, with as few
// operations as possible.

#include "idiophone/foundation/element/tetrahedra.hpp"

namespace idiophone::solid {

template <class Element>
struct NodalGradient;

template <>
struct NodalGradient<element::Tet4> {
  /// Derivatives of a nodal field along xi_1, xi_2, xi_3 at each quadrature point.
  template <class Number>
  static void differentiate(const Number (&field)[4], Number (&slope)[1][3]) {
    for (int k = 0; k < 3; ++k) {
      slope[0][k] = field[k + 1] - field[0];
    }
  }

  /// The transpose of `differentiate`: nodal_a = sum over points and directions of flux times dN_a/dxi.
  template <class Number>
  static void assemble(const Number (&flux)[1][3], Number (&nodal)[4]) {
    nodal[0] = -(flux[0][0] + flux[0][1] + flux[0][2]);
    for (int k = 0; k < 3; ++k) {
      nodal[k + 1] = flux[0][k];
    }
  }
};

template <>
struct NodalGradient<element::Tet10> {
  /// As Tet4's. Along edge 0k of the tetrahedron the derivative is 4 sum_c L_c d_c - (f_k - f_0), with L_c the
  /// barycentric coordinates and d_c the difference of the two nodes half an edge apart that point from corner c along
  /// the edge's direction. At Gauss point q all L_c are `far` but L_q, so four points cost little more than one.
  template <class Number>
  static void differentiate(const Number (&field)[10], Number (&slope)[4][3]) {
    for (int k = 0; k < 3; ++k) {
      Number difference[4];
      Number sum = {};
      for (int c = 0; c < 4; ++c) {
        difference[c] = field[half_edges[k][c][1]] - field[half_edges[k][c][0]];
        sum += difference[c];
      }
      const Number common = 4.0 * far * sum - (field[k + 1] - field[0]);
      for (int q = 0; q < 4; ++q) {
        slope[q][k] = common + 4.0 * (near - far) * difference[q];
      }
    }
  }

  /// As Tet4's.
  template <class Number>
  static void assemble(const Number (&flux)[4][3], Number (&nodal)[10]) {
    for (Number& value : nodal) {
      value = Number{};
    }
    for (int k = 0; k < 3; ++k) {
      const Number sum = flux[0][k] + flux[1][k] + flux[2][k] + flux[3][k];
      for (int c = 0; c < 4; ++c) {
        const Number term = 4.0 * far * sum + 4.0 * (near - far) * flux[c][k];
        nodal[half_edges[k][c][1]] += term;
        nodal[half_edges[k][c][0]] -= term;
      }
      nodal[k + 1] -= sum;
      nodal[0] += sum;
    }
  }

 private:
  static constexpr double near = element::Tet10::near;
  static constexpr double far = element::Tet10::far;

  /// The half edge parallel to edge 0-(k+1) that belongs to corner c: from which node to which, [k][c].
  static constexpr int half_edges[3][4][2] = {
      {{0, 4}, {4, 1}, {6, 5}, {7, 8}}, {{0, 6}, {4, 5}, {6, 2}, {7, 9}}, {{0, 7}, {4, 8}, {6, 9}, {7, 3}}};
};

}  // namespace idiophone::solid
