#pragma once
// How decks call a physical group.

#include <string>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesh {

/// The name of a group; its number where the file gives it none.
[[nodiscard]] inline std::string name_of(const GroupBlock& group) {
  return group.name.empty() ? std::to_string(group.tag) : group.name;
}

}  // namespace idiophone::mesh
