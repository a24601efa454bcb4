#pragma once
// Sounds of blows for the tests.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace idiophone::report {

inline constexpr double rate = 44100.0;

/// A damped sine that begins with a blow.
struct Tone {
  double start = 0.0;  ///< s
  double frequency = 440.0;
  double amplitude = 1.0;
  double decay_time = 1.0;  ///< T60, s
};

/// The sum of tones, each with a click of 2 ms of noise at its start, as blows have.
inline std::vector<double> blows(const std::vector<Tone>& tones, double duration) {
  std::vector<double> samples(static_cast<std::size_t>(duration * rate), 0.0);
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  for (const auto& [start, frequency, amplitude, decay_time] : tones) {
    const auto begin = static_cast<std::size_t>(start * rate);
    for (std::size_t n = begin; n < samples.size(); ++n) {
      const double time = static_cast<double>(n - begin) / rate;
      samples[n] += amplitude * std::pow(1e-3, time / decay_time) * std::sin(2 * std::numbers::pi * frequency * time);
      samples[n] += time < 0.002 ? 0.1 * amplitude * noise(random) : 0.0;
    }
  }
  return samples;
}

}  // namespace idiophone::report
