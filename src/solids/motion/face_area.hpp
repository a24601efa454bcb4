#pragma once
// The area of a face between its corners.

#include <Eigen/Geometry>
#include <span>

#include "idiophone/foundation/types.hpp"

namespace idiophone::motion {

/// Along the normal about which the corners run counter-clockwise, m2; of a quadrilateral, that of its two triangles.
/// @param position  (corner) -> Vector3, m
template <class Position>
[[nodiscard]] Vector3 area_vector(std::span<const Index> corners, const Position& position) {
  const Vector3 first = position(corners[0]);
  Vector3 area = Vector3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const Vector3 along = position(corners[k - 1]) - first, across = position(corners[k]) - first;
    area += 0.5 * along.cross(across);
  }
  return area;
}

}  // namespace idiophone::motion
