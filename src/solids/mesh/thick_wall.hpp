#pragma once
// From the middle surface of a thin body to layers of hexahedra.

#include "gmsh_mesh.hpp"
#include "surface_mesh.hpp"

namespace idiophone::mesh {

/// The wall of the body's thickness around a surface whose quadrilaterals face the same side. Each node of the surface
/// becomes a column of evenly spaced nodes, which have its tag. It lies along the mean of the normals of the
/// quadrilaterals around the node, weighted by their angles there (Thürmer and Wüthrich 1998), and is lengthened at
/// bends, so that the wall keeps its thickness on both sides. The columns of a group's nodes are in the group. Element
/// tags are those of the quadrilaterals. A node without quadrilaterals stays alone. A body with layers has an element
/// of each layer in each quadrilateral: those of the first layer, then those of the next one.
/// @return hexahedra of the surface's order, as element::hex(order, order) with evenly spaced nodes; their third
///         direction leads through the thickness
/// @throws deck::DeckError, pointing at the body's mesh key, when quadrilaterals are flat or meet at too sharp an edge;
///         pointing at the thickness, when it folds an element: it says where, and the limit.
[[nodiscard]] GmshMesh thick_wall(const scene::Body& body, const SurfaceMesh& surface);

}  // namespace idiophone::mesh
