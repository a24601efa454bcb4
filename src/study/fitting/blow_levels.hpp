#pragma once
// How loud the blows of a deck on a body are.

#include <string>
#include <vector>

#include "idiophone/instruments/sound_maps/solid_map.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::fitting {

/// Levels at listeners of the sound that the forces of a deck make on one of its bodies, from the sound map that
/// `idiophone map` would make of it: struck in the middle of the loads' patches. The sound lasts as long as the deck's.
/// On this rank alone.
/// @param body       its name; empty for the first
/// @param listeners  names of channels: "ear", "ears.left"
/// @param solved     this body, with the modes that sound
/// @return A-weighted sound exposure levels (LAE), dB re 20 uPa; spectra::silence for silence. [listeners]
/// @throws std::runtime_error for a body or a listener that the deck has not; deck::DeckError for a body without
///         forces, and for loads on it that are no forces; what sound_maps::map_of() throws
[[nodiscard]] std::vector<double> blow_levels(const scene::Scene& scene, const std::string& body,
                                              const std::vector<std::string>& listeners,
                                              sound_maps::SolvedSolid solved);

}  // namespace idiophone::fitting
