#pragma once
// Damping of a material from the decay times of its modes.

#include <array>
#include <optional>
#include <vector>

#include "idiophone/scene/material.hpp"

namespace idiophone::fitting {

/// A mode's decay.
struct Decay {
  double frequency = 0.0;   ///< Hz
  double decay_time = 0.0;  ///< T60, s
};

/// The band of a loss factor for some decays: the default one, widened where decays lie outside, Hz.
[[nodiscard]] std::array<double, 2> band_around(const std::vector<Decay>& decays);

/// The damping with ln(1000)/T60 = mass/2 + loss_factor w/2 + stiffness w^2/2 whose rates are nearest to the measured
/// ones in relative terms (least squares, none of the three below 0). Of n decays no more than n/2 of the three are
/// determined, and at least one; the loss factor then goes first, mass before stiffness. Its band is that around
/// the decays. None without decays.
[[nodiscard]] std::optional<scene::Damping> fit_damping(const std::vector<Decay>& decays);

/// Sum of the squares of the relative errors of the rates.
/// @param damping  the same in all directions and at all frequencies
[[nodiscard]] double squares_of(const scene::Damping& damping, const std::vector<Decay>& decays);

}  // namespace idiophone::fitting
