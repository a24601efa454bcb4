#pragma once
// What a deck and a mesh say about the map of a solid, before its modes are known.

#include <span>
#include <string>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::sound_maps {

/// Names, deck, material and air.
/// @param bodies  one, or those that joints tie together; the first one gives its name
void add_facts(SoundMap& map, const scene::Scene& scene, std::span<const scene::Body> bodies);

/// What keeps the modes of a body from being those of another density or stiffness times a factor: "it has supports";
/// empty if nothing does.
[[nodiscard]] std::string why_not_scalable(const scene::Body& body);

/// Everything but the frequencies.
/// @param mesh  of the body
[[nodiscard]] ScalableModes scalable_modes(const scene::Scene& scene, const scene::Body& body, const mesh::Mesh& mesh);

}  // namespace idiophone::sound_maps
