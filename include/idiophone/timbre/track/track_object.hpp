#pragma once
// An object among the sounds of a soundtrack.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::timbre {

struct SoundHandle {
  std::size_t index;
};

/// A box. It shades sounds, lets a part of them through by its mass (LimpWall), and reflects the rest.
struct TrackObject {
  /// Where it is.
  struct Pose {
    Vector3 centre = Vector3::Zero();                    ///< m
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< unit vectors along its edges, in the columns
  };
  Vector3 size = Vector3::Ones();              ///< lengths of its edges, m
  std::optional<double> surface_density = {};  ///< kg/m2; nothing gets through without one
  double absorption = 0.0;                     ///< part of the energy that would be reflected
  std::function<Pose(double time)> pose;       ///< at a time, s
  std::vector<SoundHandle> own = {};           ///< sounds of the object itself: it neither shades nor reflects them
};

}  // namespace idiophone::timbre
