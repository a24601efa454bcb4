#pragma once
// The straight ways of sound past and by way of a box.

#include <Eigen/Core>
#include <optional>

#include "idiophone/foundation/types.hpp"

namespace idiophone::timbre {

/// A box at one moment.
struct Box {
  /// A face: the one where the axis has its highest (sign 1) or lowest (sign -1) coordinate.
  struct Face {
    Eigen::Index axis = 0;
    double sign = 1.0;
    bool operator==(const Face&) const = default;
  };
  /// A straight way meets a face.
  struct Meeting {
    Face face;
    double cosine = 1.0;  ///< of the angle off its normal
    Vector3 point;        ///< m
  };

  Vector3 centre = Vector3::Zero();                    ///< m
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< unit vectors, in the columns
  Vector3 half = Vector3::Ones();                      ///< half of its edges, m

  /// Where a way enters the box, or leaves it if it begins inside; none if it stays outside or inside.
  [[nodiscard]] std::optional<Meeting> crossing(const Vector3& from, const Vector3& to) const;

  /// The face that mirrors a source to a receiver, both outside: there is one at most.
  [[nodiscard]] std::optional<Meeting> reflection(const Vector3& from, const Vector3& to) const;

  /// The mirror image of a place behind a face.
  [[nodiscard]] Vector3 mirrored(const Vector3& place, Face face) const;
  [[nodiscard]] Vector3 mirrored_direction(const Vector3& direction, Face face) const;
};

}  // namespace idiophone::timbre
