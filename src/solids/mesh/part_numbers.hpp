#pragma once
// The global numbers of what a rank has read of mesh files.

#include <vector>

#include "curve_division.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::mesh {

/// The meshes of one rank have nodes, elements and triangles with numbers of their own.
struct PartNumbers {
  Offsets here;                               ///< of the rank's meshes
  Offsets all;                                ///< of the whole meshes
  std::vector<Index> nodes;                   ///< [nodes of the rank's meshes] global
  std::vector<std::vector<Index>> elements;   ///< [bodies][elements of the rank's mesh] in the body
  std::vector<std::vector<Index>> triangles;  ///< [bodies][triangles of the rank's mesh] in the body
  std::vector<Index> surface_nodes;           ///< of all bodies, global, ascending

  /// Gives a part that was made from the rank's meshes the global numbers.
  void renumber(Part& part, const NodeDivision& division) const;
};

}  // namespace idiophone::mesh
