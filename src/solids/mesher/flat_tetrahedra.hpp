#pragma once
// Flat tetrahedra, which gmsh's algorithm HXT can leave in coarse meshes.

#include <string>
#include <vector>

namespace idiophone::mesher {

/// Meshes the present model again by Delaunay's algorithm if a tetrahedron of it has no volume but for rounding.
/// @param keeps_surface  only the volume is meshed again
/// @return a note for the user, if it did
/// @throws what gmsh throws
[[nodiscard]] std::vector<std::string> mend_flat_tetrahedra(bool keeps_surface);

}  // namespace idiophone::mesher
