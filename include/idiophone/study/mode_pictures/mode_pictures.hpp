#pragma once
// Pictures of mode shapes that a browser shows.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mode_pictures {

/// A surface whose modes are drawn.
struct Surface {
  std::span<const Vector3> nodes;                   ///< m
  std::span<const std::array<Index, 3>> triangles;  ///< in the order that makes normals point outwards
};

constexpr std::size_t most_triangles = 20000;  ///< of a surface, or the file becomes too large

/// An SVG file with a picture of each mode: the deformed surface, seen from above and the side. Red moves outwards,
/// blue inwards, and white is at rest.
/// @param shapes  [modes][3 x nodes]
/// @param titles  [modes]
/// @throws std::runtime_error for a surface with too many triangles
[[nodiscard]] std::string svg_of_modes(const Surface& surface, const std::vector<std::vector<double>>& shapes,
                                       const std::vector<std::string>& titles);

/// @throws std::runtime_error for a surface with too many triangles
void require_drawable(std::size_t triangles);

}  // namespace idiophone::mode_pictures
