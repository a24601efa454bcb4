#pragma once
// How a proxy goes from place to place.

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

#include "idiophone/foundation/types.hpp"

namespace idiophone::engines {

/// Evenly from one pose to the next. Poses lead from the coordinates of the body to those of the world.
class ProxyMotion {
 public:
  /// @param start   audio sample
  /// @param length  audio samples, at least 1
  void go(const Eigen::Isometry3d& pose, std::int64_t start, std::int64_t length) {
    from_ = at(start);
    to_ = pose;
    start_ = start;
    length_ = static_cast<double>(length);
  }

  /// It is there at once.
  void jump(const Eigen::Isometry3d& pose) { from_ = to_ = pose; }

  [[nodiscard]] Eigen::Isometry3d at(std::int64_t sample) const {
    const double share = static_cast<double>(sample - start_) / length_;
    if (share >= 1.0 || from_.matrix() == to_.matrix()) {
      return to_;
    }
    const double part = std::max(share, 0.0);
    const Eigen::Quaterniond turn(from_.linear()), next(to_.linear());
    const Vector3 place = (1.0 - part) * from_.translation() + part * to_.translation();
    return Eigen::Translation3d(place) * turn.slerp(part, next);
  }

 private:
  Eigen::Isometry3d from_ = Eigen::Isometry3d::Identity(), to_ = Eigen::Isometry3d::Identity();
  std::int64_t start_ = 0;
  double length_ = 1.0;
};

}  // namespace idiophone::engines
