#pragma once
// Sound maps of membranes, strings, bars and plates, by their equations (van den Doel and Pai 1996).

#include <optional>

#include "idiophone/instruments/sound_maps/ideal_body.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::sound_maps {

/// Modes and surface of an ideal body. Fills in everything except for `code_version`, `resolved_deck` and the
/// radiation. Call on one rank.
/// @param count  how many modes, the lowest, where `up_to` is not given
/// @param up_to  all modes up to this frequency, Hz
/// @throws eigenmodes::NoModes where there are no modes; std::runtime_error where there are not so many, or a membrane
/// can't be meshed
[[nodiscard]] sound_maps::SoundMap ideal_map(const scene::Scene& scene, const sound_maps::IdealBody& body, int count,
                                             std::optional<double> up_to);

}  // namespace idiophone::sound_maps
