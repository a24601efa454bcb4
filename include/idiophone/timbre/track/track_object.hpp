#pragma once
// An object among the sounds of a soundtrack.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::timbre {

struct SoundHandle {
  std::size_t index;
};

/// A box, or any solid. It shades sounds, lets a part of them through by its mass (LimpWall), and reflects the rest.
struct TrackObject {
  /// Where it is.
  struct Pose {
    Vector3 centre = Vector3::Zero();                    ///< of a box, or the origin of the triangles, m
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< unit vectors along its edges, in the columns
  };
  Vector3 size = Vector3::Ones();                      ///< lengths of the edges of a box, m
  std::vector<std::array<Vector3, 3>> triangles = {};  ///< closed surface of a solid that is no box, m; see ObjectShape
  std::optional<double> surface_density = {};          ///< kg/m2; nothing gets through without one
  double absorption = 0.0;                             ///< part of the energy that would be reflected
  std::function<Pose(double time)> pose;               ///< at a time, s
  std::vector<SoundHandle> own = {};                   ///< sounds of the object itself, which it does not change
};

}  // namespace idiophone::timbre
