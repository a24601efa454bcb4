#pragma once
// The power of a sound, for tests that compare sounds.

#include <vector>

namespace idiophone::voices {

/// Sum of the squares of all samples.
inline double power(const std::vector<double>& sound) {
  double sum = 0.0;
  for (const double sample : sound) {
    sum += sample * sample;
  }
  return sum;
}

}  // namespace idiophone::voices
