#pragma once
// How loud a sound map is.

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::engines {

/// The root of the mean square of the pressure at 1 m after an impulse of 1 N s, Pa/(N s): the mean over all places and
/// directions of the impulse, and over all directions of the listener.
[[nodiscard]] double loudness_of(const sound_maps::SoundMap& map);

}  // namespace idiophone::engines
