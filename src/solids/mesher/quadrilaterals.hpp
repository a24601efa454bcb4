#pragma once
// Surfaces of a geometry, meshed with quadrilaterals.

namespace idiophone::mesher {

/// Meshes all surfaces of the present model with quadrilaterals only. gmsh joins pairs of triangles; where triangles
/// remain, elements of twice the size are divided, each into quadrilaterals.
/// @throws what gmsh throws
void mesh_with_quadrilaterals();

}  // namespace idiophone::mesher
