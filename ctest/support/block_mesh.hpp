#pragma once
// Meshes for tests and benchmarks that need no mesher: a block of cells, each one hexahedron or cut into six
// tetrahedra.

#include <array>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::support {

/// A block from the origin to `size` (m) with `cells` cells along x, y, z. Groups: "x0" and "x1", the faces at x = 0
/// and at x = size; "rim", the faces at both ends of x and y.
[[nodiscard]] mesh::Mesh block_mesh(element::Type element, const Vector3& size, const std::array<int, 3>& cells);

/// The whole mesh as the one part of a job with one rank.
[[nodiscard]] mesh::Part whole_part(const mesh::Mesh& mesh);

}  // namespace idiophone::support
