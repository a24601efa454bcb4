#pragma once
// The part of the surface of joined bodies that the air touches.

#include <array>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::joints {

struct ExposedSurface {
  std::vector<Index> nodes;               ///< its vertices, ascending
  std::vector<mesh::Triangle> triangles;  ///< as places in `nodes`
};

/// Leaves out the triangles that joints cover, and the vertices that only they have. Vertices of two bodies that lie at
/// one place of the border of a joint become one, the one with the lower number.
/// @param part     all of the bodies
/// @param covered  [triangles] by joints::covered_triangles()
[[nodiscard]] ExposedSurface exposed_surface(const mesh::Part& part, const std::vector<char>& covered);

/// Whether each edge has as many triangles on the one side as on the other.
[[nodiscard]] bool is_closed(std::span<const std::array<Index, 3>> triangles);

}  // namespace idiophone::joints
