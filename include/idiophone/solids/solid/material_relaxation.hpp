#pragma once
// The complex modulus that the damping of a material stands for.

#include "idiophone/scene/material.hpp"
#include "idiophone/solids/solid/relaxation.hpp"

namespace idiophone::solid {

/// Of the loss factor alone; constant without one.
/// @throws deck::DeckError as fit_relaxation()
[[nodiscard]] Relaxation relaxation_of_loss(const scene::Damping& damping);

/// Of the loss factor, and of mass-proportional damping that acts on the vibration alone (creeping()).
/// @throws deck::DeckError as fit_relaxation(), and where creep is not slower than all of the loss factor's mechanisms
[[nodiscard]] Relaxation relaxation_of(const scene::Damping& damping);

}  // namespace idiophone::solid
