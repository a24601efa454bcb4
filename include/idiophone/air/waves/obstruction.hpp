#pragma once
// The surfaces that bound the air.

#include <array>
#include <span>

#include "idiophone/foundation/types.hpp"

namespace idiophone::waves {

/// Closed surfaces, on every rank the same. What is inside any of them is no air.
struct Obstruction {
  std::span<const std::array<Index, 3>> triangles;  ///< vertices, in the order that makes normals point into the air
  std::span<const float> positions;                 ///< [3 x vertices] m

  [[nodiscard]] Vector3 corner(Index triangle, int k) const {
    const float* const x = &positions[3UL * triangles[triangle][k]];
    return {x[0], x[1], x[2]};
  }
};

}  // namespace idiophone::waves
