#pragma once
// What `idiophone modes` writes.

#include <mpi.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/frequency_bounds.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::app {

/// What a file says of its modes.
struct ModesFile {
  const scene::Scene& scene;  ///< of the bodies that have the modes; its name is the deck's, or with the first body's
  std::string mass;           ///< matrix that they were found with: "lumped", or "lumped with air"
  const eigenmodes::Modes& found;
  const std::vector<double>& mesh_errors;  ///< [modes] cents; empty without
  const std::optional<eigenmodes::FrequencyBounds>& bounds;
  const std::vector<std::string>& kinds;  ///< [modes] empty texts for unknown ones
  nlohmann::json facts;                   ///< rank 0's
};

/// The name of the files, without extension: NAME_modes.
[[nodiscard]] std::string name_of_modes(const scene::Scene& scene);

/// What modes are of: the deck, and on rank 0 the meshes of the bodies.
/// @param scene  of these bodies
[[nodiscard]] nlohmann::json facts_of_modes(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes);

/// Writes NAME_modes.h5 and NAME_modes.xdmf into a folder, with the modes of each body. Collective.
/// @param part     of all bodies of the scene
/// @param offsets  of them
void write_modes(const std::filesystem::path& folder, const ModesFile& file, const mesh::Part& part,
                 const mesh::Offsets& offsets, MPI_Comm communicator);

/// Draws NAME_modes.svg. On rank 0.
/// @param shapes  [modes][3 x nodes]
/// @param kinds   [modes]
void draw_modes(const std::filesystem::path& path, const mesh::Mesh& mesh, const eigenmodes::Modes& found,
                const std::vector<std::vector<double>>& shapes, const std::vector<std::string>& kinds);

}  // namespace idiophone::app
