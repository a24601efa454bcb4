#pragma once
// The partition of meshes by METIS.

#include <metis.h>

#include <vector>

namespace idiophone::mesh {

/// METIS's mesh: elements as lists of vertices, in compressed rows, and what vertices and elements cost.
struct ElementLists {
  std::vector<idx_t> begins;      ///< [elements + 1]
  std::vector<idx_t> nodes;       ///< [begins.back()]
  std::vector<idx_t> weights;     ///< [vertices] work of the elements around it
  std::vector<std::size_t> work;  ///< [elements] of its nodes
};

/// METIS minimises the links between ranks, but a run waits for its busiest rank. Below 50 000 vertices METIS gives ten
/// partitions by each of its two methods: nine single ones, and the one of ten that has the fewest links. The one whose
/// busiest rank computes the least is taken. The same lists give the same partition.
/// @return the rank of each vertex; METIS may leave a rank without one
/// @throws std::runtime_error when METIS fails
[[nodiscard]] std::vector<idx_t> metis_parts(ElementLists lists, idx_t ranks);

}  // namespace idiophone::mesh
