#pragma once
// Which simple form a body has.

#include <Eigen/Core>
#include <span>
#include <string>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mode_kinds {

struct BodyForm {
  enum class Kind {
    bar,    ///< at least 3.5 times as long as wide
    plate,  ///< rectangular, at most a fifth as thick as wide
    disc,   ///< round, at most a quarter as high as wide
    shell,  ///< round and higher: a bell, a tube, a bowl
    other
  };
  Kind kind = Kind::other;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: along length, width and thickness; of round bodies,
                                                       ///< the last one is the axis
  Vector3 centre = Vector3::Zero();                    ///< of the box along the axes, m
  Vector3 extents = Vector3::Zero();                   ///< of that box, m
};

[[nodiscard]] BodyForm form_of(std::span<const Vector3> nodes);

/// "z" for a direction within some degrees of an axis of coordinates; else `otherwise`.
[[nodiscard]] std::string direction_name(const Vector3& direction, const std::string& otherwise);

}  // namespace idiophone::mode_kinds
