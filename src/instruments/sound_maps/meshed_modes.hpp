#pragma once
// Modes of membranes and plates of any outline, by finite elements.

#include "idiophone/instruments/sound_maps/ideal_body.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/solids/eigenmodes/membrane.hpp"

namespace idiophone::sound_maps {

/// The density of a body, which of a membrane can vary with the place: kg/m2, of strings and bars kg/m. It throws
/// deck::DeckError where a formula gives a value that no body has.
[[nodiscard]] eigenmodes::PlaneField density_of(const IdealBody& body);

/// Adds frequencies, shapes and the surface.
/// @throws deck::DeckError where a formula gives a value that no body has; std::runtime_error where there are no modes,
/// or the body
///         can't be meshed
void add_meshed_modes(SoundMap& map, const IdealBody& body, const eigenmodes::WantedModes& wanted);

}  // namespace idiophone::sound_maps
