#pragma once
// Order along Hilbert's space-filling curve: what is near in space becomes near in memory.

#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mesh {

/// The points' numbers in the order in which the Hilbert curve through the points' bounding cube visits them. Points in
/// one cell of its 2^21 x 2^21 x 2^21 grid follow by x, y, z, points in one place by number.
/// @param points  [points], finite, m
[[nodiscard]] std::vector<Index> curve_order(const std::vector<Vector3>& points);

}  // namespace idiophone::mesh
