#pragma once
// What `idiophone map` warns of.

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// What of the deck does not reach its maps.
void warn_of_what_maps_lack(const scene::Scene& scene);

/// Listeners and bodies whose levels are doubtful.
/// @throws deck::DeckError where listeners or the body are where they can't be
void check_map_placement(const scene::Scene& scene, const sound_maps::SoundMap& map);

/// Gives a map the mass of the air, if it is asked for, and says which modes have none. Otherwise it says where the
/// mass matters.
void take_air_mass(sound_maps::SoundMap& map, bool in_air);

}  // namespace idiophone::app
