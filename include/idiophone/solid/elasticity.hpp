#pragma once
// Stress from strain, linearly: St. Venant-Kirchhoff elasticity where the two are the second Piola-Kirchhoff stress and
// Green's strain.

#include <Eigen/Core>
#include <variant>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solid/pack.hpp"

namespace idiophone::solid {

/// S = lambda tr(E) I + 2 mu E
struct IsotropicElasticity {
  double lambda = 0.0;  ///< Lame's first constant, Pa
  double mu = 0.0;      ///< shear modulus, Pa

  /// Stress times `weight`, Pa times its unit.
  [[nodiscard]] PackSymmetric stress(const PackSymmetric& strain, const Pack& weight) const {
    const Pack pressure = lambda * weight * (strain.at[0] + strain.at[1] + strain.at[2]);
    const Pack shear = 2 * mu * weight;
    PackSymmetric s;
    for (int i = 0; i < 3; ++i) {
      s.at[i] = shear * strain.at[i] + pressure;
      s.at[3 + i] = shear * strain.at[3 + i];
    }
    return s;
  }
};

using Elasticity = std::variant<IsotropicElasticity>;

/// The elasticity that a material's constants stand for, made stiffer by a factor.
[[nodiscard]] Elasticity elasticity(const scene::Material& material, double factor = 1.0);

/// C of S = C E with S = (S_xx, S_yy, S_zz, S_yz, S_xz, S_xy) and E = (E_xx, E_yy, E_zz, 2 E_yz, 2 E_xz, 2 E_xy), Pa.
[[nodiscard]] Eigen::Matrix<double, 6, 6> stiffness_matrix(const Elasticity& elasticity);

}  // namespace idiophone::solid
