#pragma once
// Lists with names in a mesh file, without their members.

#include <string>
#include <vector>

#include "mesh_table_reader.hpp"

namespace idiophone::mesh {

/// List i has the rows of the members from begins[i] to before begins[i + 1].
struct ListOutline {
  std::vector<std::string> names;  ///< [lists]
  std::vector<Index> begins;       ///< [lists + 1], from 0 to the rows
};

/// @param group  path of the lists
/// @param width  numbers of a member
/// @throws std::runtime_error unless the lists fill the rows of the members, and have different names
[[nodiscard]] ListOutline read_list_outline(const MeshTables& tables, const std::string& group, int width);

}  // namespace idiophone::mesh
