#pragma once
// A plane that reflects sound, by image receivers.

#include "idiophone/air/radiation/paths.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::radiation {

/// An infinite plane.
struct ReflectingPlane {
  Vector3 at = Vector3::Zero();       ///< a point of it, m
  Vector3 normal = Vector3::UnitZ();  ///< unit vector
  double reflection = 1.0;            ///< reflected pressure over incident pressure, real: the same at all frequencies

  /// The mirror image of a direction.
  [[nodiscard]] Vector3 mirrored(const Vector3& direction) const {
    return direction - 2.0 * direction.dot(normal) * normal;
  }
};

/// The image receiver: in free field it receives the reflection from the floor. It is the mirror image of the receiver,
/// its gain multiplied by the reflection. Exact for a rigid (reflection 1) or soft (-1) floor and any motion.
[[nodiscard]] ReceiverState image(const ReceiverState& receiver, const ReflectingPlane& floor);

}  // namespace idiophone::radiation
