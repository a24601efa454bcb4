#pragma once
// Groups of nodes of the present model.

#include <vector>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesher {

/// The physical groups.
/// @param of_body  dimension of the elements that the body is made of
[[nodiscard]] std::vector<mesh::GroupBlock> groups(int of_body);

/// Groups of the faces of a part, by their numbers: CAD files name none. (Those of the volumes; other ones have nodes
/// that no element uses.)
/// @param dimension  of the elements that the body is made of
[[nodiscard]] std::vector<mesh::GroupBlock> numbered_faces(int dimension);

}  // namespace idiophone::mesher
