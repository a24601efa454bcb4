#pragma once
// The Sonic Explorer: sound maps as a web page on which bodies are struck and heard (van den Doel and Pai 1996,
// section 5).

#include <span>
#include <string>

#include "idiophone/store/sound_map.hpp"

namespace idiophone::explorer {

/// One HTML page with everything in it: surfaces, modes, scripts. Shapes of modes are rounded to 16 bits, -90 dB of
/// their largest value.
/// @param maps            of one deck: at least one, with the same listeners of one or two receivers
/// @param shortest_delay  of the sound from a body to a receiver, audio samples
/// @throws std::runtime_error if the maps have no listeners, more than two receivers, or different ones
[[nodiscard]] std::string page(std::span<const store::SoundMap> maps, double shortest_delay);

}  // namespace idiophone::explorer
