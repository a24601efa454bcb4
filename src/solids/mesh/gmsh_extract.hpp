#pragma once
// From the answer of idiophone_gmsh into our own arrays.

#include "gmsh_mesh.hpp"
#include "idiophone/solids/mesh/meshing.hpp"
#include "surface_mesh.hpp"

namespace idiophone::mesh {

// Both take nodes, elements and physical groups of an answer without objections. A group without a name is called by
// its number. They throw deck::DeckError when the answer holds no elements of the kind that the body needs, or others,
// when a position isn't finite, there are too many nodes, or elements or groups name nodes that don't exist.

/// Tetrahedra of the body's type, or gmsh's hexahedra of some order as element::hex(order, order) with evenly spaced
/// nodes.
[[nodiscard]] GmshMesh extract(const scene::Body& body, const MeshingAnswer& answer);

/// The quadrilaterals of a body with a thickness.
[[nodiscard]] SurfaceMesh extract_surface(const scene::Body& body, const MeshingAnswer& answer);

}  // namespace idiophone::mesh
