#pragma once
// How loud the blows of a deck on a body are.

#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"

namespace idiophone::fitting {

/// Levels at listeners of the sound that the forces of a deck make on one of its bodies, from the sound map that
/// `idiophone map` would make of it: modes up to Audio::max_frequency, struck in the middle of the loads' patches. The
/// sound lasts as long as the deck's. On this rank alone.
/// @param body       its name; empty for the first
/// @param listeners  names of channels: "ear", "ears.left"
/// @return A-weighted sound exposure levels (LAE), dB re 20 uPa; spectra::silence for silence. [listeners]
/// @throws std::runtime_error for a body or a listener that the deck has not; deck::DeckError for a body without
///         forces, and for loads on it that are no forces; what sound_maps::solid_map() throws
[[nodiscard]] std::vector<double> blow_levels(const scene::Scene& scene, const std::string& body,
                                              const std::vector<std::string>& listeners, eigenmodes::MassMatrix mass);

}  // namespace idiophone::fitting
