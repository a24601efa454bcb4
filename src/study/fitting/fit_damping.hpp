#pragma once
// Damping of a material from the decay times of its modes.

#include <optional>
#include <vector>

#include "idiophone/scene/material.hpp"

namespace idiophone::fitting {

/// A mode's decay.
struct Decay {
  double frequency = 0.0;   ///< Hz
  double decay_time = 0.0;  ///< T60, s
};

/// The damping with ln(1000)/T60 = mass/2 + loss_factor w/2 + stiffness w^2/2 whose rates are nearest to the measured
/// ones in relative terms (least squares, none of the three below 0). Of n decays no more than n/2 of the three are
/// determined, and at least one; the loss factor then goes first, mass before stiffness. Its band is the default one,
/// widened where decays lie outside. None without decays.
[[nodiscard]] std::optional<scene::Damping> fit_damping(const std::vector<Decay>& decays);

}  // namespace idiophone::fitting
