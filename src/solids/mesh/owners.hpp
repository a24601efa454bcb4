#pragma once
// Which rank owns which node.

#include <vector>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::mesh {

/// Work of an element for each of its nodes: a tet10 element takes 10 x 2, a tet4 element 4 x 1, a node of a hexahedron
/// about as much as one of tet10.
[[nodiscard]] int work_of_node(element::Type type);

/// The owning rank of every node of all bodies, [global nodes]: METIS's parts with a fixed seed, or equal chunks along
/// the curve where METIS would leave a rank without nodes.
/// @throws std::runtime_error when the bodies have fewer nodes or elements than there are ranks, or more than 32-bit
///         METIS can part
[[nodiscard]] std::vector<int> node_owners(const std::vector<Mesh>& meshes, int ranks);

}  // namespace idiophone::mesh
