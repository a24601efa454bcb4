#pragma once
// What `idiophone map` warns of.

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// What of the deck does not reach its maps.
void warn_of_what_maps_lack(const scene::Scene& scene);

/// @throws std::runtime_error if a body has large amplitudes: the mass of the air would change its modes, but not what
/// is known of their stretching
void refuse_air_mass_of_large_amplitudes(const scene::Scene& scene);

/// Says that the sound of something is that of small vibrations, if the map has large ones.
/// @param what  "the page", for example
void warn_of_small_vibrations(const sound_maps::SoundMap& map, const std::string& what);

/// Listeners and bodies whose levels are doubtful.
/// @throws deck::DeckError where listeners or the body are where they can't be
void check_map_placement(const scene::Scene& scene, const sound_maps::SoundMap& map);

/// Gives a map the mass of the air, if it is asked for, and says which modes have none. Otherwise it says where the
/// mass matters.
void take_air_mass(sound_maps::SoundMap& map, bool in_air);

}  // namespace idiophone::app
