#pragma once
// How far the parts of a body with large amplitudes may turn (docs/method/large_amplitudes.md, Limits).

#include <fmt/format.h>

#include <string>

namespace idiophone::modal_bodies {

/// Rotation angle, root mean square over the body, up to which pitches are right within about ten cents, rad.
inline constexpr double largest_right_rotation = 0.1;

/// What a warning says of a larger one.
[[nodiscard]] inline std::string too_large_rotation(double rotation) {
  return fmt::format(
      "its vibration turns its parts by {:.3g} rad in the root mean square: large_amplitudes is right up to {} rad",
      rotation, largest_right_rotation);
}

}  // namespace idiophone::modal_bodies
