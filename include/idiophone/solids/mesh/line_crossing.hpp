#pragma once
// Where a line meets a triangle.

#include <optional>

#include "idiophone/solids/mesh/triangle_point.hpp"

namespace idiophone::mesh {

/// Meets the line from + t direction with a triangle (Moeller and Trumbore 1997).
/// @param slack  by which the linear weights of the crossing may lie beyond the edges
/// @return t; none if the line misses the triangle or is parallel to it
[[nodiscard]] std::optional<double> line_crossing(const TrianglePoints& corners, const Vector3& from,
                                                  const Vector3& direction, double slack = 0.0);

}  // namespace idiophone::mesh
