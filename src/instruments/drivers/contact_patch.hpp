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

  /// Points that each take an equal part of the force, m: six with the mean and the covariance of the patch, which
  /// follow the covariance without jumps. The middle alone where the standard deviation is below a millimetre in all
  /// directions.
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
