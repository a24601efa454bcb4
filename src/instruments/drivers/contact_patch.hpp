#pragma once
// Where a contact acts: points that stand for the patch in which two bodies touch.

#include <Eigen/Core>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::drivers {

/// The place of a contact force.
struct ContactPatch {
  Vector3 middle = Vector3::Zero();                  ///< mean place, weighted by pressure, m
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< covariance of the places, likewise, m2

  /// Points with the mean and the covariance of the patch, m, each of which takes an equal part of the force: two on
  /// each axis of the covariance along which the patch reaches a millimetre or more. The middle alone for a smaller
  /// patch.
  [[nodiscard]] std::vector<Vector3> points() const;
};

/// The patch of several times: places and spreads weighted by the force.
class MeanPatch {
 public:
  /// @param weight  N
  void add(const ContactPatch& patch, double weight);

  /// The mean of those added, of which one at least had a weight.
  [[nodiscard]] ContactPatch mean() const;

 private:
  Vector3 places_ = Vector3::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();  // about the origin
  double weights_ = 0.0;
};

}  // namespace idiophone::drivers
