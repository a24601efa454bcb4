#pragma once
// The modes of a body of finite elements, as a sound map without sound.

#include <cstddef>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

namespace idiophone::sound_maps {

/// Meshes a body and finds its modes on this rank alone, so that their bits do not depend on the number of ranks. Fills
/// in everything except for `code_version`, `resolved_deck` and the radiation.
/// @param body       index into Scene::bodies. Its loads, contacts and all other bodies are left out.
/// @param estimates  of the error of the mesh
/// @throws deck::DeckError as mesh::read_mesh() and motion::attach(), std::runtime_error as eigenmodes::find_modes()
[[nodiscard]] sound_maps::SoundMap solid_map(const scene::Scene& scene, std::size_t body,
                                             const eigenmodes::Options& options, eigenmodes::Estimates estimates);

}  // namespace idiophone::sound_maps
