#pragma once
// What METIS divides among the ranks.

#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// Nodes, or several of them that one rank owns together.
struct PartitionVertices {
  std::vector<Index> of_node;  ///< [nodes of all bodies] their vertices, in the order of the first nodes
  Index count = 0;
};

/// One rank owns
/// - the nodes of a body that has to stay whole,
/// - those on the fracture surfaces of a body, with their columns through the thickness: it knows all about what
/// breaks,
/// - those of a hexahedron that belong to the same elements. A rank that owns one of them computes these elements
///   anyway.
/// @throws std::invalid_argument if a mesh is to be beside one that is not earlier in the list
[[nodiscard]] PartitionVertices partition_vertices(const std::vector<Mesh>& meshes);

}  // namespace idiophone::mesh
