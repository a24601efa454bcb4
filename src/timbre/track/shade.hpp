#pragma once
// A wall that comes into the way of a sound and leaves it again.

#include "idiophone/timbre/nodes/limp_wall.hpp"

namespace idiophone::timbre {

/// A number that goes from one value to another within an interval.
struct Fade {
  double from = 0.0, to = 0.0;
  [[nodiscard]] double at(double part) const { return from + part * (to - from); }
};

/// A wall in the way, and how much of the sound goes through it.
struct Shade {
  LimpWall wall;
  Fade part;

  /// For the next interval.
  /// @param corner  of the wall if it is in the way, over the rate
  void aim(bool is_in_the_way, double corner) {
    part = {.from = part.to, .to = is_in_the_way ? 1.0 : 0.0};
    if (is_in_the_way) {
      wall.tune(corner);
    }
  }

  /// The next sample behind it. @param interval_part  how far it is within the interval, 0 to 1
  double step(double sound, double interval_part) {
    return sound + part.at(interval_part) * (wall.step(sound) - sound);
  }
};

}  // namespace idiophone::timbre
