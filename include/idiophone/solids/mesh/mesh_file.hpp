#pragma once
// NAME.mesh.h5: a mesh that is made once and read often. Written by one process, over MPI_COMM_SELF. Reading
// makes no MPI calls.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "idiophone/foundation/origin.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// A body's mesh before a deck puts it in a place and gives it materials.
struct StoredMesh {
  std::string body;  ///< of the deck that it was made from
  Mesh mesh;         ///< numbered along the curve, in the axes of its file, without regions and fracture faces
  /// Physical group -> its elements, ascending. A layer of a wall is a group, called by its number from 1.
  std::map<std::string, std::vector<Index>> element_groups;
};

/// What the body's file becomes without the body's rotation, position and groups. Its notes say what of the file it
/// leaves out. Call on one rank only.
/// @throws deck::DeckError as read_mesh()
[[nodiscard]] StoredMesh storable_mesh(const scene::Body& body);

/// Writes a mesh, or replaces a file by it. The file is either the old one or the new one, whatever happens.
/// @param origin  the deck that it was made from
/// @throws std::runtime_error with the system's reason
void write_mesh_file(const std::filesystem::path& path, const StoredMesh& stored, const Origin& origin);

/// @throws std::runtime_error, naming the file, when it can't be opened, is no mesh, is damaged, or contradicts itself
[[nodiscard]] StoredMesh read_mesh_file(const std::filesystem::path& path);

}  // namespace idiophone::mesh
