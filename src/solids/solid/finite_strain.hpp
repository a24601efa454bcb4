#pragma once
// Strains and stresses of finite deformation for the elements of a pack at once, from displacement gradients H = du/dX
// (docs/method/theory.md, The solid).
//
// Green's strain is used in its H form, E = (H + H^T + H^T H)/2: a small strain survives a large rotation in it, and
// would be lost in F^T F - I.

#include "idiophone/solids/solid/pack.hpp"

namespace idiophone::solid {

/// A - B/2
[[nodiscard]] inline PackMatrix minus_half(const PackMatrix& a, const PackMatrix& b) {
  PackMatrix c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      c.at[i][j] = a.at[i][j] - 0.5 * b.at[i][j];
    }
  }
  return c;
}

/// Green's strain E of H.
[[nodiscard]] inline PackSymmetric green_strain(const PackMatrix& h) {
  return symmetric_sum(h, h, minus_half(h, h));
}

/// E + beta dE/dt from H and G = H + beta dH/dt: sym(G + H^T (G - H/2)), as dE/dt = sym(H' + H^T H').
[[nodiscard]] inline PackSymmetric delayed_strain(const PackMatrix& h, const PackMatrix& delayed) {
  return symmetric_sum(delayed, h, minus_half(delayed, h));
}

/// E(H) - E(H - D) without the cancellation of their difference: sym(D + D^T (H - D/2)).
[[nodiscard]] inline PackSymmetric strain_change(const PackMatrix& h, const PackMatrix& change) {
  return symmetric_sum(change, change, minus_half(h, change));
}

/// First Piola-Kirchhoff stress P = F S = S + H S.
[[nodiscard]] inline PackMatrix first_piola(const PackMatrix& h, const PackSymmetric& s) {
  PackMatrix p;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      p.at[i][j] = s(i, j) + h.at[i][0] * s(0, j) + h.at[i][1] * s(1, j) + h.at[i][2] * s(2, j);
    }
  }
  return p;
}

/// A : B
[[nodiscard]] inline Pack contract(const PackSymmetric& a, const PackSymmetric& b) {
  Pack sum = {};
  for (int i = 0; i < 3; ++i) {
    sum += a.at[i] * b.at[i] + 2 * a.at[3 + i] * b.at[3 + i];
  }
  return sum;
}

}  // namespace idiophone::solid
