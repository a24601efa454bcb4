#pragma once
// What a contact does as a whole: one row of its motion channels.

#include "idiophone/foundation/types.hpp"

namespace idiophone::contact {

struct ContactMotion {
  Vector3 force = Vector3::Zero();   ///< on the first body, N
  Vector3 point = Vector3::Zero();   ///< where it acts: mean place, weighted by pressure, m
  Vector3 normal = Vector3::Zero();  ///< unit vector from the partner to the first body, likewise
  Vector3 slip = Vector3::Zero();    ///< tangential velocity of the first body against the partner, likewise, m/s
  double overlap = 0.0;              ///< volume, m3
  /// Covariance of the places where it acts, weighted by pressure, m2: how far the patch reaches around the point.
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
};

}  // namespace idiophone::contact
