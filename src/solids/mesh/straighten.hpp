#pragma once
// Straight edges where curved ones would fold an element.

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

/// Straightens the edges of quadratic elements that curved edges fold or flatten, so that the mesh is not refused for
/// them. Elements that share these edges come out straighter, too.
/// @returns how many were made straight and where the first of them are, as a note for the user; empty where none was
[[nodiscard]] std::string straighten_distorted(Mesh& mesh);

}  // namespace idiophone::mesh
