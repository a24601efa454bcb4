#pragma once
// Which elements of a mesh have which material, by its physical groups.

#include <vector>

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

/// @param loaded  nodes, elements and groups, in the file's order
/// @return [elements] as Mesh::regions
/// @throws deck::DeckError, pointing at the region, when the file has no such group of elements, or an element is in
///         two regions; pointing at the first one, when elements are in none. It names elements and groups.
[[nodiscard]] std::vector<Index> regions_by_group(const scene::Body& body, const GmshMesh& loaded);

}  // namespace idiophone::mesh
