#pragma once
// A file whose unit of length is probably not the metre is refused before gmsh spends minutes on it.

#include <vector>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesher {

/// Compares the box around the open file with the `size` of its elements. A file in millimetres that is read as metres
/// has a thousand million times as many elements as meant. Nothing is asked of a file whose `scale` the deck gives.
/// @return an objection at `size` when the box would have more than 10^9 tetrahedra, or 10^7 quadrilaterals of a wall;
///         otherwise nothing
[[nodiscard]] std::vector<mesh::Objection> doubts_about_unit(const mesh::MeshingRequest& request);

}  // namespace idiophone::mesher
