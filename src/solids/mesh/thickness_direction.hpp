#pragma once
// Which direction of each hexahedron leads through the thickness of a body.

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

/// For each hexahedron the one of its own directions xi_1, xi_2, xi_3 (0, 1, 2) that leads through the thickness. All
/// edges that it is parallel to are through the thickness for every element that has them, and no other edge is. Of the
/// choices that are possible, the one with the shortest edges on average. Where none is, a body of elements with equal
/// orders has direction 2 everywhere, and so has a body with a thickness.
/// @param geometry  hexahedra as gmsh made them
/// @throws deck::DeckError, pointing at the body's mesh key, when the orders differ and there is no such choice; it
///         names elements that can't agree with their neighbours.
[[nodiscard]] std::vector<int> thickness_directions(const scene::Body& body, const GmshMesh& geometry);

}  // namespace idiophone::mesh
