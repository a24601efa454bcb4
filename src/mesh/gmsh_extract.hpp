#pragma once
// From the answer of idiophone_gmsh into our own arrays.

#include "gmsh_mesh.hpp"
#include "idiophone/mesh/meshing.hpp"

namespace idiophone::mesh {

/// Nodes, elements and physical groups of an answer without objections: tetrahedra of the body's type, or gmsh's
/// hexahedra of some order as element::hex(order, order) with evenly spaced nodes. A group without a name is called by
/// its number.
/// @throws deck::DeckError when it holds no volume elements, or others than the body needs, when a
///         position isn't finite, there are too many nodes, or elements or groups name nodes that don't exist.
[[nodiscard]] GmshMesh extract(const scene::Body& body, const MeshingAnswer& answer);

}  // namespace idiophone::mesh
