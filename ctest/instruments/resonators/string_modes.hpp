#pragma once
// The modes of an ideal string.

#include <cmath>
#include <numbers>
#include <vector>

#include "touched_body.hpp"

namespace idiophone::resonators {

/// Mode n of a string decays with lowest + rise n^2.
struct StringDecay {
  double lowest = 0.0, rise = 0.0;  ///< 1/s
};

/// @param share  of the string's length at which it is bowed
inline std::vector<TouchedMode> string_modes(double frequency, double mass, double share, const StringDecay& decay,
                                             int count) {
  std::vector<TouchedMode> modes;
  for (int n = 1; n <= count; ++n) {
    modes.push_back({.frequency = n * frequency,
                     .decay = decay.lowest + decay.rise * n * n,
                     .participation = std::sqrt(2.0 / mass) * std::sin(n * std::numbers::pi * share)});
  }
  return modes;
}

}  // namespace idiophone::resonators
