#pragma once
// How loud a source is in each direction.

#include <array>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::timbre {

/// The same all around an axis.
struct Directivity {
  double share = 0.0;  ///< d of the pattern 1 - d + d cos(angle off the axis); 0.5: a cardioid, 1: a figure of eight
  std::vector<std::array<double, 2>> levels =
      {};                           ///< instead: rows of (angle off the axis, degrees; level, dB), ascending
  Vector3 axis = Vector3::UnitX();  ///< unit vector; of a sound with a body, in the undeformed body
  /// Instead: one for each octave band from scene::lowest_octave on, about this axis. Empty: the same at all
  /// frequencies.
  std::vector<Directivity> bands = {};

  /// Of the pressure at all frequencies, where the angle off the axis has this cosine. Levels between two rows are
  /// linear in the angle.
  [[nodiscard]] double gain(double cosine) const;

  /// Root mean square of the gain over all directions: what it is worth in a diffuse field.
  [[nodiscard]] double diffuse_gain() const;
};

}  // namespace idiophone::timbre
