#pragma once
// From gmsh's hexahedra to spectral ones.

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

inline constexpr int lowest_geometry_order = 2;  ///< gmsh then has a node on each edge, on each face and in each cell
inline constexpr int highest_geometry_order = 4;

/// The mesh of a body of spectral hexahedra. Their third direction leads through the thickness. Nodes are placed by the
/// shape functions of gmsh's elements; those on an edge or a face that elements share are the same. A node is in a
/// group if gmsh's nodes within its edge, face or cell are. Its tag is that of such a node.
/// @param geometry  gmsh's hexahedra of order 2 to 4, as element::hex(order, order) with evenly spaced nodes
/// @throws deck::DeckError, pointing at the body's mesh key, when elements can't agree which direction leads through
/// the thickness, or two that share the corners of an edge or a face have different ones between them.
[[nodiscard]] GmshMesh spectral_mesh(const scene::Body& body, const GmshMesh& geometry);

}  // namespace idiophone::mesh
