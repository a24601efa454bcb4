#pragma once
// Velocities of surfaces at the audio rate become those at the steps of the waves.

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace idiophone::waves {

/// The last few audio samples of many signals, and their band-limited interpolation (listening::Spreading::least_squares) in the one
/// interval for which the samples before and after it suffice.
class VelocityHistory {
 public:
  /// @param steps  in an audio sample
  VelocityHistory(std::size_t signals, int steps);

  /// The interval ends this many audio samples before the newest one.
  [[nodiscard]] static std::int64_t latency();

  /// As if the signals had always had this value.
  void fill(std::span<const float> values);
  /// The next audio sample.
  void push(std::span<const float> values);

  /// What the signals change from half a step before the beginning of a step to half a step after it.
  /// @param step     of the interval, from 0 on
  /// @param changes  [signals]
  void changes(int step, std::span<float> changes) const;

  /// All samples, oldest first: [samples x signals].
  [[nodiscard]] std::vector<double> samples() const;
  void restore(std::span<const double> samples);

 private:
  std::vector<std::vector<float>> weights_;  // [steps][samples]
  std::deque<std::vector<float>> samples_;   // oldest first
};

}  // namespace idiophone::waves
