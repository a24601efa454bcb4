#pragma once
// The modes of a body of finite elements, or of bodies that joints tie together, as a sound map without sound.

#include <cstddef>
#include <vector>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::sound_maps {

/// A body with those that joints tie to it, and their modes.
struct SolvedSolid {
  scene::Scene assembly;                ///< these bodies alone
  std::vector<mesh::Mesh> meshes = {};  ///< [bodies of the assembly]
  motion::Attachments attachments = {};
  mesh::Part part = {};
  eigenmodes::Options options;   ///< of the search
  eigenmodes::Modes found = {};  ///< by their frequencies, ascending
};

/// Meshes a body with those that joints tie to it and finds their modes on this rank alone, so that their bits do not
/// depend on the number of ranks.
/// @param body    index into Scene::bodies. Loads, contacts and other bodies are left out.
/// @param wanted  modes; double ones are aligned where amplitudes are large
/// @throws deck::DeckError as mesh::read_mesh() and motion::attach(); std::runtime_error as eigenmodes::find_modes()
[[nodiscard]] SolvedSolid solve_solid(const scene::Scene& scene, std::size_t body, const eigenmodes::Options& wanted);

/// Fills in everything except for `code_version`, `resolved_deck` and the radiation. The surface is that of all bodies
/// of the assembly, without the triangles that joints cover (joints::covered_triangles()).
/// @param scene      that was solved
/// @param estimates  of the error of the mesh; there are none of a body with joints
/// @throws deck::DeckError where joints cover all of the surface
[[nodiscard]] SoundMap map_of(const scene::Scene& scene, SolvedSolid solved, eigenmodes::Estimates estimates);

/// The map of a body that is solved first. Its name is the map's.
/// @throws what solve_solid() and map_of() throw
[[nodiscard]] SoundMap solid_map(const scene::Scene& scene, std::size_t body, const eigenmodes::Options& wanted,
                                 eigenmodes::Estimates estimates);

}  // namespace idiophone::sound_maps
