#pragma once
// Sound maps as voices: each mode is a resonator. The audio thread's part never locks, allocates or frees.

#include <memory>
#include <vector>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/instruments/voices/voice.hpp"

namespace idiophone::voices {

/// A voice for each map.
/// @param audience  audience_of() the maps, or another; must have somebody
/// @param rate      audio samples per second; modes from half of it on are left out
/// @throws std::runtime_error when a map is too far away
[[nodiscard]] std::vector<std::unique_ptr<Voice>> sound_map_voices(std::vector<sound_maps::SoundMap> maps,
                                                                   const Audience& audience, int rate);

/// The same for maps that several voices share: each voice is a body of its own.
[[nodiscard]] std::vector<std::unique_ptr<Voice>> sound_map_voices(
    const std::vector<std::shared_ptr<const sound_maps::SoundMap>>& maps, const Audience& audience, int rate);

/// The listeners of sound maps, at which they are heard with their near field.
/// @throws std::runtime_error when maps have different listeners, or more than can be played
[[nodiscard]] Audience audience_of(const std::vector<sound_maps::SoundMap>& maps);

/// The shortest delay of sound from a body to a receiver, audio samples: nearer receivers hear it as late.
[[nodiscard]] double shortest_delay();

}  // namespace idiophone::voices
