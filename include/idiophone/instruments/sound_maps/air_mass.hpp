#pragma once
// The mass of the air in the modes of a sound map.

#include <cstddef>

#include "idiophone/air/harmonic/wet_modes.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// The modes as they are without air.
/// @param map  of a solid, as solid_map() makes it
[[nodiscard]] harmonic::DryModes dry_modes(const SoundMap& map);

/// Gives the modes the mass of the air: frequency, shape and material decay. The radiation comes after that, at the new
/// frequencies.
/// @param map  as of dry_modes()
/// @return how many modes, the lowest, the surface resolves; the others stay as they are
/// @throws std::runtime_error where the surface is open at the borders of joints
std::size_t add_air_mass(SoundMap& map);

}  // namespace idiophone::sound_maps
