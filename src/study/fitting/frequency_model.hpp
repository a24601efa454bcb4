#pragma once
// Frequencies of a body as functions of its elastic constants, from its modes at nearby ones.

#include <Eigen/Core>
#include <vector>

#include "elastic_constants.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::fitting {

/// Modes of one frequency, or so close that measurements don't separate them. Their own shapes are an arbitrary basis,
/// so only means over all of them have a meaning.
struct Multiplet {
  int first = 0;                                                   ///< number of its first mode, from 0
  int count = 0;                                                   ///< modes
  double square = 0.0;                                             ///< mean of w^2, (rad/s)^2
  solid::StiffnessMatrix strain = solid::StiffnessMatrix::Zero();  ///< mean of strain_products, m3
};

/// A mode for a multiplet.
struct StrainedMode {
  double frequency = 0.0;  ///< Hz
  solid::StiffnessMatrix strain;
};

class FrequencyModel {
 public:
  /// @param modes     of the body with this material, ascending
  /// @param material  that they belong to
  /// @param axes      of a material that is not isotropic and not turned, in the body, in the columns
  FrequencyModel(const std::vector<StrainedMode>& modes, const TurnedMaterial& material, Eigen::Matrix3d axes);

  [[nodiscard]] const std::vector<Multiplet>& multiplets() const { return multiplets_; }

  /// Axes of a material in the body, in the columns.
  [[nodiscard]] Eigen::Matrix3d axes_of(const TurnedMaterial& material) const { return axes_ * material.turn(); }

  /// Frequencies (Hz) of all multiplets with another material: w^2 + (C - C_0) : Q. Exact to first order in C - C_0.
  [[nodiscard]] Eigen::VectorXd frequencies(const TurnedMaterial& material) const;

  /// Derivatives of their cents by the unknowns of the constants, [multiplets x constants].
  [[nodiscard]] Eigen::MatrixXd cents_slopes(const ElasticConstants& constants, const TurnedMaterial& material) const;

 private:
  [[nodiscard]] solid::StiffnessMatrix stiffness(const TurnedMaterial& material) const;

  Eigen::Matrix3d axes_;
  solid::StiffnessMatrix stiffness_;  ///< C_0
  std::vector<Multiplet> multiplets_;
};

/// Whether every strain of the material costs energy.
[[nodiscard]] bool is_stable(const scene::Material& material);

}  // namespace idiophone::fitting
