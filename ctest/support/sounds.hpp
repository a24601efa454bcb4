#pragma once
// Synthetic sounds whose partials are known exactly.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace idiophone::partials {

inline constexpr double rate = 44100.0;

/// One damped cosine.
struct Planted {
  double frequency = 0.0;   ///< Hz
  double amplitude = 1.0;   ///< at time 0
  double decay_time = 1.0;  ///< T60, s
  double phase = 0.3;       ///< radians
};

/// What a sound is made of besides its partials.
struct Disturbance {
  double noise = 0.0;     ///< standard deviation of white Gaussian noise
  double constant = 0.0;  ///< offset
  double thump = 0.0;     ///< amplitude of e^(-t/10 ms)
  unsigned seed = 2001;   ///< of the noise
};

inline std::vector<double> sound(std::span<const Planted> partials, double duration, Disturbance disturbance = {}) {
  std::vector<double> samples(static_cast<std::size_t>(std::lround(duration * rate)));
  std::mt19937 generator(disturbance.seed);
  std::normal_distribution<double> normal;
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double t = static_cast<double>(n) / rate;
    double sum =
        disturbance.constant + disturbance.thump * std::exp(-100.0 * t) + disturbance.noise * normal(generator);
    for (const Planted& partial : partials) {
      sum += partial.amplitude * std::exp(-std::log(1000.0) * t / partial.decay_time) *
             std::cos(2.0 * std::numbers::pi * partial.frequency * t + partial.phase);
    }
    samples[n] = sum;
  }
  return samples;
}

}  // namespace idiophone::partials
