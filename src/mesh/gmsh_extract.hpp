#pragma once
// From gmsh's present model into our own arrays.

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

/// Makes the present model's tetrahedra first or second order, as the body asks.
/// @throws deck::DeckError when it holds no volume elements, or others than tetrahedra; what gmsh throws.
void bring_to_order(const scene::Body& body);

/// Nodes, tetrahedra and physical groups of the present model. A group without a name is called by its number.
/// @throws deck::DeckError when a position isn't finite or there are too many nodes; what gmsh throws.
[[nodiscard]] GmshMesh extract(const scene::Body& body);

}  // namespace idiophone::mesh
