#pragma once
// The point of a triangle that is nearest to a place.

#include <array>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mesh {

/// Corners of a triangle, m.
using TrianglePoints = std::array<Vector3, 3>;

/// The point with these linear weights, m.
[[nodiscard]] Vector3 at_weights(const TrianglePoints& corners, const Vector3& weights);

[[nodiscard]] double longest_edge(const TrianglePoints& corners);

/// Linear weights of the point of the triangle that is nearest to `point`.
[[nodiscard]] Vector3 nearest_weights(const TrianglePoints& corners, const Vector3& point);

}  // namespace idiophone::mesh
