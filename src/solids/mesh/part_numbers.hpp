#pragma once
// The global numbers of what a process has read of mesh files.

#include <vector>

#include "curve_division.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::mesh {

/// The meshes of one process have nodes, elements and triangles with numbers of their own.
struct PartNumbers {
  Offsets here;                               ///< of the process's meshes
  Offsets all;                                ///< of the whole meshes
  std::vector<Index> nodes;                   ///< [nodes of the process's meshes] global
  std::vector<std::vector<Index>> elements;   ///< [bodies][elements of the process's mesh] in the body
  std::vector<std::vector<Index>> triangles;  ///< [bodies][triangles of the process's mesh] in the body
  std::vector<Index> surface_nodes;           ///< of all bodies, global, ascending

  /// Gives a part that was made from the process's meshes the global numbers.
  void renumber(Part& part, const NodeDivision& division) const;
};

}  // namespace idiophone::mesh
