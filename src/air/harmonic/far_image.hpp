#pragma once
// The far field above a floor.

#include <complex>
#include <optional>

#include "idiophone/air/radiation/floor.hpp"

namespace idiophone::harmonic {

/// Far field of sources and of their mirror images. A direction behind the floor has the value of its mirror image.
/// @param towards  far field of the sources in a direction
template <class Towards>
[[nodiscard]] std::complex<double> with_image(const std::optional<radiation::ReflectingPlane>& floor,
                                              double wave_number, const Vector3& wanted, const Towards& towards) {
  if (!floor) {
    return towards(wanted);
  }
  const Vector3 mirrored = floor->mirrored(wanted);
  const bool is_behind = floor->normal.dot(wanted) < 0;
  const Vector3 direction = is_behind ? mirrored : wanted;
  const Vector3 image = is_behind ? wanted : mirrored;
  return towards(direction) +
         floor->reflection * std::polar(1.0, wave_number * (direction - image).dot(floor->at)) * towards(image);
}

}  // namespace idiophone::harmonic
