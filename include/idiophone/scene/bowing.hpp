#pragma once
// How a bow rubs a body, in decks and in scores.

#include "idiophone/foundation/friction/law.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/course.hpp"

namespace idiophone::scene {

/// What a bow, or a finger, does. Times count from its beginning.
struct Bowing {
  Vector3 direction = Vector3::UnitX();  ///< in which the bow moves; unit vector
  Course speed;                          ///< of the bow, m/s
  Course load;                           ///< that presses it on, N; not negative
  double duration = 60.0;                ///< s
  friction::Law friction;

  /// The load rises and falls over 10 ms where the bow begins and ends, N; zero before and after it. Realtime-safe.
  /// @param time  s
  [[nodiscard]] double load_at(double time) const;
};

}  // namespace idiophone::scene
