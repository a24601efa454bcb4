#pragma once
// A mesh in whose elements every motion of a given mesh is possible, and more.

#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// What a node of the given mesh gives to a node of the refined one.
struct Parent {
  Index node = 0;       ///< of the given mesh
  double weight = 0.0;  ///< its shape function there; not 0
};

struct RefinedMesh {
  Mesh mesh;                                 ///< of the same shape, without hash, notes and fracture faces
  std::vector<std::vector<Parent>> parents;  ///< [nodes of `mesh`] ascending
};

/// Refines each element: tet4 becomes tet10, tet10 becomes eight tet10, and hexahedra get orders that are higher by
/// one. A direction of the highest order is halved instead. A node is in a group where all its parents are.
/// @param mesh  not divided
[[nodiscard]] RefinedMesh refined(const Mesh& mesh);

/// About how many entries the stiffness matrix of refined() has: those of all its elements.
[[nodiscard]] double refined_entries(const Mesh& mesh);

/// At most how many times as many nodes refined() elements have.
[[nodiscard]] double refined_nodes(element::Type type);

}  // namespace idiophone::mesh
