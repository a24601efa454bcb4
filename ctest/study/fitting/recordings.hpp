#pragma once
// Sounds of struck bodies for tests: damped sines and noise.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace idiophone::fitting {

struct DampedSine {
  double frequency = 0.0;   ///< Hz
  double decay_time = 1.0;  ///< T60, s
  double amplitude = 0.3;
};

/// A tenth of a second of silence, then all sines, and noise all the time.
/// @param noise  root mean square
inline std::vector<double> struck(const std::vector<DampedSine>& sines, int rate, double duration, double noise = 0.0) {
  std::mt19937 generator(17);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<double> samples(std::lround(rate * duration));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / rate - 0.1;
    samples[i] = noise * normal(generator);
    for (const auto& [frequency, decay_time, amplitude] : sines) {
      samples[i] += t < 0 ? 0.0
                          : amplitude * std::exp(-t * std::log(1000.0) / decay_time) *
                                std::sin(2 * std::numbers::pi * frequency * t);
    }
  }
  return samples;
}

}  // namespace idiophone::fitting
