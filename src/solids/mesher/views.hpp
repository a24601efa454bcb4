#pragma once
// Numbers that a .msh file gives its nodes and elements.

#include <vector>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesher {

/// The views of the file that is open which are data of nodes or elements.
[[nodiscard]] std::vector<mesh::ViewBlock> views();

}  // namespace idiophone::mesher
