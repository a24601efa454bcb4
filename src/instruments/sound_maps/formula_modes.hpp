#pragma once
// Modes of strings, bars and supported rectangular plates, by formulas.

#include "idiophone/instruments/sound_maps/ideal_body.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// Adds frequencies, shapes and the surface.
/// @throws std::runtime_error where there are too many modes
void add_formula_modes(SoundMap& map, const IdealBody& body, const eigenmodes::WantedModes& wanted);

}  // namespace idiophone::sound_maps
