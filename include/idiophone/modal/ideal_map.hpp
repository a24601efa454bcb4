#pragma once
// Sound maps of membranes, strings, bars and plates, by their equations (van den Doel and Pai 1996).

#include <optional>

#include "idiophone/scene/ideal_body.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/store/sound_map.hpp"

namespace idiophone::modal {

/// Modes and surface of an ideal body. Fills in everything except for `code_version`, `resolved_deck` and the
/// radiation. Call on one rank.
/// @param count  how many modes, the lowest, where `up_to` is not given
/// @param up_to  all modes up to this frequency, Hz
/// @throws std::runtime_error where there are no modes, or a membrane can't be meshed
[[nodiscard]] store::SoundMap ideal_map(const scene::Scene& scene, const scene::IdealBody& body, int count,
                                        std::optional<double> up_to);

}  // namespace idiophone::modal
