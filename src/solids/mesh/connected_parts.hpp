#pragma once
// What of a mesh hangs together.

#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// The part of the mesh that each node belongs to: parts share no node. They are numbered from 0 in the order of their
/// first nodes. [nodes]
[[nodiscard]] std::vector<Index> connected_parts(const Mesh& mesh);

}  // namespace idiophone::mesh
