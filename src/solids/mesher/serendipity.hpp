#pragma once
// Quadratic elements without nodes within their faces (serendipity elements).

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesher {

/// Gives the hexahedra of 20 nodes and the quadrilaterals of 8 nodes of an answer the nodes within faces and cells that
/// make them ones of 27 and 9 nodes. They lie where the shape functions of the elements put them, so no shape changes.
/// Groups that have the faces or cells get the nodes. The present model is that of the answer.
/// @throws what gmsh throws
void complete_serendipity(mesh::MeshingAnswer& answer);

}  // namespace idiophone::mesher
