#pragma once
// Meshes of spectral hexahedra for tests and benchmarks that need no mesher.

#include <array>

#include "idiophone/mesh/part.hpp"
#include "idiophone/solid/packed_hexahedra.hpp"

namespace idiophone::support {

/// A block from the origin to `size` (m) with `cells` hexahedra along x, y, z, as the one part of a job with one rank;
/// xi_3 is along z. Nodes are numbered in the order in which the elements reach them.
[[nodiscard]] mesh::Part hexahedra_block(const solid::HexahedronOrder& order, const Vector3& size,
                                         const std::array<int, 3>& cells);

}  // namespace idiophone::support
