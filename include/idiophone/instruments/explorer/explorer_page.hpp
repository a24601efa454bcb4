#pragma once
// The Sonic Explorer: sound maps as a web page on which bodies are struck and heard (van den Doel and Pai 1996,
// section 5).

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::explorer {

/// The proxies of a body, the finest first.
using ProxyLevels = std::vector<std::shared_ptr<const proxies::Lattice>>;

/// Whether the program was built with WebAssembly. Without it, pages have small vibrations only.
[[nodiscard]] bool has_webassembly();

/// One HTML page with everything in it: surfaces, modes, scripts. Shapes of modes are rounded to 16 bits, -90 dB of
/// their largest value.
/// @param maps            of one deck, with the same listeners of one or two receivers; without maps the page has only
///                        the bodies that it makes itself, and one listener
/// @param shortest_delay  of the sound from a body to a receiver, audio samples
/// @param proxies         of the bodies of the maps; or none at all
/// @throws std::runtime_error if the maps have no listeners, more than two receivers, or different ones
[[nodiscard]] std::string page(std::span<const sound_maps::SoundMap> maps, double shortest_delay,
                               std::span<const ProxyLevels> proxies = {});

}  // namespace idiophone::explorer
