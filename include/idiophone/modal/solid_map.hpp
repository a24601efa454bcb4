#pragma once
// The modes of a body of finite elements, as a sound map without sound.

#include <cstddef>

#include "idiophone/modes/modes.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/store/sound_map.hpp"

namespace idiophone::modal {

/// Meshes a body and finds its modes on this rank alone, so that their bits do not depend on the number of ranks. Fills
/// in everything except for `code_version`, `resolved_deck` and the radiation.
/// @param body  index into Scene::bodies. Its loads, contacts and all other bodies are left out.
/// @throws deck::DeckError as mesh::read_mesh() and motion::attach(), std::runtime_error as modes::find_modes()
[[nodiscard]] store::SoundMap solid_map(const scene::Scene& scene, std::size_t body, const modes::Options& options);

}  // namespace idiophone::modal
