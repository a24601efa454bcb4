#pragma once
// Loss factors of the moduli of wood, from the decay times of modes that strain different ones.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "fit_damping.hpp"
#include "idiophone/scene/material.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::fitting {

/// A mode's decay, and how it strains its body (Multiplet::strain).
struct StrainedDecay {
  Decay decay;
  solid::StiffnessMatrix strain = solid::StiffnessMatrix::Zero();  ///< m3
};

struct DirectionalLossFit {
  scene::LossFactor loss;  ///< with the default band
  double squares = 0.0;    ///< sum of the squares of the relative errors of the rates
};

/// The loss factors by direction whose decay rates are nearest to the measured ones in relative terms (least squares).
/// All directions share one loss factor at first. Those that bring the rates clearly nearer get one of their own, the
/// best one first: as long as the sum of squares falls by more than chance would let it. n decays give at most n/2
/// numbers.
/// @param material  orthotropic
/// @param axes      its own, in the body, in the columns
/// @return none if no direction has a loss factor of its own
[[nodiscard]] std::optional<DirectionalLossFit> fit_directional_loss(const scene::Material& material,
                                                                     const Eigen::Matrix3d& axes,
                                                                     const std::vector<StrainedDecay>& decays);

}  // namespace idiophone::fitting
