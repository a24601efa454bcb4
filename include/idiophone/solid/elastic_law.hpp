#pragma once
// St. Venant-Kirchhoff elasticity with Kelvin-Voigt damping (O'Brien and Hodgins 1999; PHYSICS.md, 1).

#include "idiophone/scene/scene.hpp"
#include "idiophone/solid/pack.hpp"

namespace idiophone::solid {

/// S = lambda tr(A) I + 2 mu A with A = E + beta dE/dt: the same as phi = beta lambda and psi = beta mu.
struct ElasticLaw {
  double lambda = 0.0;  ///< Lame's first constant, Pa
  double mu = 0.0;      ///< shear modulus, Pa
  double beta = 0.0;    ///< damping proportional to stiffness, s

  ElasticLaw() = default;
  explicit ElasticLaw(const scene::Material& material)
      : lambda(material.young * material.poisson / ((1 + material.poisson) * (1 - 2 * material.poisson))),
        mu(material.young / (2 * (1 + material.poisson))),
        beta(material.damping.stiffness) {}

  /// First Piola-Kirchhoff stress P = F S, Pa, times `weight`.
  /// @param h        displacement gradient H = du/dX
  /// @param delayed  H + beta dH/dt, the gradient of u + beta v
  ///
  /// Green's strain is used in its H form, E = (H + H^T + H^T H)/2: a small strain survives a large rotation in it, and
  /// would be lost in F^T F - I. With its rate E' = sym(H' + H^T H'), the damped strain is A = sym(G + H^T (G - H/2)),
  /// G = delayed.
  [[nodiscard]] PackMatrix stress(const PackMatrix& h, const PackMatrix& delayed, const Pack& weight) const {
    PackMatrix rest;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        rest.at[i][j] = delayed.at[i][j] - 0.5 * h.at[i][j];
      }
    }
    PackSymmetric s = symmetric_sum(delayed, h, rest);
    const Pack pressure = lambda * weight * (s.at[0] + s.at[1] + s.at[2]);
    const Pack shear = 2 * mu * weight;
    for (int i = 0; i < 3; ++i) {
      s.at[i] = shear * s.at[i] + pressure;
      s.at[3 + i] = shear * s.at[3 + i];
    }
    PackMatrix p;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        p.at[i][j] = s(i, j) + h.at[i][0] * s(0, j) + h.at[i][1] * s(1, j) + h.at[i][2] * s(2, j);
      }
    }
    return p;
  }

  /// Elastic energy density lambda/2 tr(E)^2 + mu E:E, J/m3.
  [[nodiscard]] Pack energy_density(const PackMatrix& h) const {
    PackMatrix half = h;
    for (auto& row : half.at) {
      for (Pack& entry : row) {
        entry *= 0.5;
      }
    }
    const PackSymmetric e = symmetric_sum(h, h, half);
    const Pack trace = e.at[0] + e.at[1] + e.at[2];
    Pack square = {};
    for (int i = 0; i < 3; ++i) {
      square += e.at[i] * e.at[i] + 2 * e.at[3 + i] * e.at[3 + i];
    }
    return 0.5 * lambda * trace * trace + mu * square;
  }
};

}  // namespace idiophone::solid
