#pragma once
// How loud a sound is and what its pitch is, by the plainest means: no code of the program takes part.

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>

namespace idiophone::support {

inline double root_mean_square(std::span<const double> sound) {
  double sum = 0.0;
  for (const double sample : sound) {
    sum += sample * sample;
  }
  return std::sqrt(sum / static_cast<double>(sound.size()));
}

/// Of the strongest partial between two frequencies, Hz, within 0.1 Hz: the largest of the projections on sines.
/// @param rate  audio samples per second
inline double pitch(std::span<const double> sound, double from, double to, double rate) {
  double best = 0.0, largest = 0.0;
  for (double frequency = from; frequency < to; frequency += 0.1) {
    std::complex<double> sum = 0.0, phase = 1.0;
    const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi * frequency / rate);
    for (std::size_t i = 0; i < sound.size(); ++i) {
      const double window =
          0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sound.size()));
      sum += window * sound[i] * phase;
      phase *= turn;
    }
    if (std::abs(sum) > largest) {
      largest = std::abs(sum);
      best = frequency;
    }
  }
  return best;
}

}  // namespace idiophone::support
