#pragma once
// The inertia of a rigid body.

#include <Eigen/Core>

namespace idiophone {

/// The inertia tensor, kg m2, of a body with these second moments: tr(S) I - S.
/// @param second  S: sum of m x x^T about the centre of mass, kg m2
[[nodiscard]] inline Eigen::Matrix3d inertia_tensor(const Eigen::Matrix3d& second) {
  return second.trace() * Eigen::Matrix3d::Identity() - second;
}

}  // namespace idiophone
