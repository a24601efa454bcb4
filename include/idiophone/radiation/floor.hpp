#pragma once
// A rigid plane that reflects sound, by the image of whoever hears it.

#include "idiophone/radiation/paths.hpp"
#include "idiophone/types.hpp"

namespace idiophone::radiation {

/// A plane without end.
struct ReflectingPlane {
  Vector3 at = Vector3::Zero();       ///< a point of it, m
  Vector3 normal = Vector3::UnitZ();  ///< unit vector
  double reflection = 1.0;            ///< reflected pressure over incident pressure, real: the same at all frequencies

  /// The direction as the mirror shows it.
  [[nodiscard]] Vector3 mirrored(const Vector3& direction) const {
    return direction - 2.0 * direction.dot(normal) * normal;
  }
};

/// What hears, in the open, just what the receiver hears by way of the floor: its mirror image, its gain times the
/// reflection. Exact for a floor that is rigid (reflection 1) or soft (-1), for every sound and any motion.
[[nodiscard]] ReceiverState image(const ReceiverState& receiver, const ReflectingPlane& floor);

}  // namespace idiophone::radiation
