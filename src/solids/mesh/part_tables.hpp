#pragma once
// The rows of a mesh file that one rank needs.

#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// Places of nodes, m, in the axes of the file. Reads across small gaps.
/// @param numbers  ascending
/// @throws std::runtime_error if they can't be read
[[nodiscard]] std::vector<Vector3> read_nodes(const scene::Body& body, std::span<const std::size_t> numbers);

/// The triangles of the surface from `begin` to before `end`.
/// @throws std::runtime_error if they can't be read
[[nodiscard]] std::vector<Triangle> read_triangles(const scene::Body& body, Index begin, Index end);

/// A triangle as places of its nodes in a list.
/// @param numbers  of the nodes in the list, ascending
/// @throws std::runtime_error if it has another node
[[nodiscard]] Triangle in_places(Triangle triangle, std::span<const std::size_t> numbers);

}  // namespace idiophone::mesh
