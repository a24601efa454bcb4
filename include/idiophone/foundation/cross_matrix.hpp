#pragma once
// The cross product with a vector as a matrix.

#include "idiophone/foundation/types.hpp"

namespace idiophone {

/// [v]: its product with w is v x w.
[[nodiscard]] inline Eigen::Matrix3d cross_matrix(const Vector3& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

}  // namespace idiophone
