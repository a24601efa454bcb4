#pragma once
// The box around some points.

#include <Eigen/Geometry>
#include <span>

#include "idiophone/foundation/types.hpp"

namespace idiophone {

/// Along the axes of the points; empty if there are none.
[[nodiscard]] inline Eigen::AlignedBox3d bounding_box(std::span<const Vector3> points) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points) {
    box.extend(point);
  }
  return box;
}

}  // namespace idiophone
