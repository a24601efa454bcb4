#pragma once
// The amplitude of a sine in a sound.

#include <cmath>
#include <numbers>
#include <vector>

namespace idiophone::timbre {

/// @param frequency  Hz, at 44100 audio samples per second
/// @param begin, end  audio samples; best a whole number of periods
inline double amplitude(const std::vector<double>& sound, double frequency, std::size_t begin, std::size_t end) {
  double real = 0.0, imaginary = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    const double phase = 2.0 * std::numbers::pi * frequency * static_cast<double>(i) / 44100.0;
    real += sound[i] * std::cos(phase);
    imaginary += sound[i] * std::sin(phase);
  }
  return 2.0 * std::hypot(real, imaginary) / static_cast<double>(end - begin);
}

}  // namespace idiophone::timbre
