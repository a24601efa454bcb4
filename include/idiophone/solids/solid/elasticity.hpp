#pragma once
// Stress from strain, linearly: St. Venant-Kirchhoff elasticity where the two are the second Piola-Kirchhoff stress and
// Green's strain.

#include <Eigen/Core>
#include <variant>

#include "idiophone/scene/material.hpp"
#include "idiophone/solids/solid/pack.hpp"

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

using scene::StiffnessMatrix;

/// The two directions of each of the six numbers of a stress or a strain.
inline constexpr int direction_pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

/// S = C E with any C
struct AnisotropicElasticity {
  StiffnessMatrix stiffness;

  /// Stress times `weight`, Pa times its unit.
  [[nodiscard]] PackSymmetric stress(const PackSymmetric& strain, const Pack& weight) const {
    Pack e[6];
    for (int j = 0; j < 3; ++j) {
      e[j] = weight * strain.at[j];
      e[3 + j] = 2 * weight * strain.at[3 + j];
    }
    PackSymmetric s;
    for (int i = 0; i < 6; ++i) {
      s.at[i] = stiffness(i, 0) * e[0];
      for (int j = 1; j < 6; ++j) {
        s.at[i] += stiffness(i, j) * e[j];
      }
    }
    return s;
  }
};

using Elasticity = std::variant<IsotropicElasticity, AnisotropicElasticity>;

/// The elasticity that a material's constants stand for.
/// @param axes    of a material that is not isotropic, in the columns
/// @param factor  makes it so much stiffer
[[nodiscard]] Elasticity elasticity(const scene::Material& material,
                                    const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity(), double factor = 1.0);

[[nodiscard]] StiffnessMatrix stiffness_matrix(const Elasticity& elasticity);

/// C of a material whose own axes are these.
/// @param stiffness  along the own axes
/// @param axes       in the columns
/// @param factor     makes it so much stiffer
[[nodiscard]] StiffnessMatrix turned(const StiffnessMatrix& stiffness, const Eigen::Matrix3d& axes,
                                     double factor = 1.0);

/// The stress that a strain makes, Pa.
/// @param strain  symmetric
[[nodiscard]] Eigen::Matrix3d stress_of(const Elasticity& elasticity, const Eigen::Matrix3d& strain);

/// The strain that makes a stress, the same in all lanes.
/// @param stress  Pa, symmetric
[[nodiscard]] PackSymmetric strain_of(const Elasticity& elasticity, const Eigen::Matrix3d& stress);

/// The least of 2 x energy density/|E|^2 of any strain E, Pa: twice the shear modulus of a solid that is isotropic,
/// with Poisson's ratio of at least 0.
[[nodiscard]] double least_stiffness(const Elasticity& elasticity);

}  // namespace idiophone::solid
