#pragma once
// The numbering of a mesh along the space-filling curve.

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// A mesh numbered along the curve, without hash and notes.
struct OrderedMesh {
  Mesh mesh;
  std::vector<Index> nodes, elements;  ///< [nodes], [elements] numbers before
};

/// Numbers nodes and elements along the curve, the elements region by region. Nodes in one place keep their order.
[[nodiscard]] OrderedMesh ordered(const Mesh& mesh);

}  // namespace idiophone::mesh
