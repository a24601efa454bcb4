#pragma once
// Whether listeners and air are those of another map.

#include <string>

#include "idiophone/scene/scene.hpp"
#include "scaled_placement.hpp"

namespace idiophone::sound_maps {

/// Whether the same listeners stand at the same places of the same air, as the body sees them. Floors and absorption do
/// not go with the body.
/// @param source         the other map
/// @param resolved_deck  of the scene
/// @param placement      of the body since then
[[nodiscard]] bool is_heard_alike(const SoundMap& source, const scene::Scene& scene, const std::string& resolved_deck,
                                  const Placement& placement);

}  // namespace idiophone::sound_maps
