#pragma once
// The keys of a loss factor, in the section damping of a material.

#include <optional>

#include "idiophone/scene/material.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

/// loss_factor, band and mechanisms.
/// @param table  of the shipped material that this one starts from
void read_loss(Section& section, Damping& damping, const std::optional<LossFactor>& table);

}  // namespace idiophone::scene
