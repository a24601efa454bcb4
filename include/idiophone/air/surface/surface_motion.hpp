#pragma once
// The motion of a surface at one audio sample, low-passed: what can be recorded, and listened to later.

#include <vector>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::surface {

/// All of one rank's triangles and vertices at one audio sample.
struct SurfaceMotion {
  std::vector<double> pressure;  ///< [padded(triangles)] z vbar.n (eqs. 2-5) after the low-pass of eqs. 6-8, Pa
  std::vector<double> position;  ///< [padded(3 x vertices + 1)] x y z of each vertex after the same low-pass, m
  /// [triangles] equivalent radii from this audio sample on, m, where triangles change over time; empty: those that the
  /// surface began with.
  std::vector<double> radii = {};

  /// Length of `position`: rows of three numbers are read four at a time.
  [[nodiscard]] static constexpr std::size_t position_length(std::size_t vertices) { return padded(3 * vertices + 1); }
};

}  // namespace idiophone::surface
