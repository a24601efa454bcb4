#pragma once
// Groups of nodes of the present model.

#include <string>
#include <vector>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesher {

/// The physical groups.
/// @param of_body  dimension of the elements that the body is made of
[[nodiscard]] std::vector<mesh::GroupBlock> groups(int of_body);

/// Says whether only some of the volumes (or surfaces) of a body are in physical groups: gmsh would save only these.
/// @param of_body  see groups()
/// @return no note if all of them are in groups, or none
[[nodiscard]] std::vector<std::string> note_on_ungrouped(int of_body);

/// Groups of the faces of a part, by their numbers: CAD files name none. (Those of the volumes; other ones have nodes
/// that no element uses.)
/// @param dimension  of the elements that the body is made of
[[nodiscard]] std::vector<mesh::GroupBlock> numbered_faces(int dimension);

}  // namespace idiophone::mesher
