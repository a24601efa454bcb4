#pragma once
// The modes of a body of finite elements, or of bodies that joints tie together, as a sound map without sound.

#include <cstddef>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

namespace idiophone::sound_maps {

/// Meshes a body with those that joints tie to it and finds their modes on this rank alone, so that their bits do not
/// depend on the number of ranks. Fills in everything except for `code_version`, `resolved_deck` and the radiation. The
/// surface is that of all these bodies, without the triangles that joints cover (joints::covered_triangles()).
/// @param body       index into Scene::bodies; its name is the map's. Loads, contacts and other bodies are left out.
/// @param wanted     modes; double ones are aligned where amplitudes are large
/// @param estimates  of the error of the mesh; there are none of a body with joints
/// @throws deck::DeckError as mesh::read_mesh() and motion::attach(), and where joints cover all of the surface;
/// std::runtime_error as eigenmodes::find_modes()
[[nodiscard]] SoundMap solid_map(const scene::Scene& scene, std::size_t body, const eigenmodes::Options& wanted,
                                 eigenmodes::Estimates estimates);

}  // namespace idiophone::sound_maps
