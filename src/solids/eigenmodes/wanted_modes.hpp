#pragma once
// The modes that the models of joined bodies ask for.

#include <span>

#include "idiophone/scene/body.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"

namespace idiophone::eigenmodes {

/// The modes of the assembly that its modal bodies ask for: up to the highest `up_to`, or as many as all of them have
/// by `count`.
[[nodiscard]] Options wanted_modes(std::span<const scene::Body> assembly);

/// The model that asks for the highest modes: where an error is that the assembly lacks them.
[[nodiscard]] const scene::ModalModel& most_demanding(std::span<const scene::Body> assembly);

}  // namespace idiophone::eigenmodes
