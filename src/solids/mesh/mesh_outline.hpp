#pragma once
// What a mesh file has without its elements.

#include <filesystem>
#include <string>

#include "idiophone/solids/mesh/mesh_file.hpp"

namespace idiophone::mesh {

/// As read_mesh_file(), without elements and groups of elements. The hash is the one that the file promises.
/// @throws std::runtime_error, naming the file, as read_mesh_file() does
[[nodiscard]] StoredMesh read_mesh_outline(const std::filesystem::path& path);

/// @param promised  what the file says
/// @throws std::runtime_error unless the hash of a mesh is the one that its file promises
void require_hash(const std::string& hash, const std::string& promised);

}  // namespace idiophone::mesh
