#pragma once
// From the views of a .msh file to values of our nodes and elements.

#include "gmsh_mesh.hpp"
#include "idiophone/solids/mesh/mesh_values.hpp"

namespace idiophone::mesh {

/// @param loaded    the mesh with the file's numbers of its nodes and elements
/// @param nodes     at which place of `loaded` each node of the ordered mesh is
/// @param elements  likewise
/// @throws deck::DeckError as read_mesh_with_values()
[[nodiscard]] std::vector<MeshValues> values_of_views(const scene::Body& body, const GmshMesh& loaded,
                                                      const std::vector<Index>& nodes,
                                                      const std::vector<Index>& elements);

}  // namespace idiophone::mesh
