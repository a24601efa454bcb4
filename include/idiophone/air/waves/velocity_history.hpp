#pragma once
// Velocities of surfaces at the audio rate become those at the steps of the waves.

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace idiophone::waves {

/// The last few audio samples of many signals, and their interpolation by a windowed sinc in the one interval for which
/// the samples before and after it suffice. Up to 0.35 of the audio rate, changes are exact within 0.3 %.
class VelocityHistory {
 public:
  /// @param steps  in an audio sample
  VelocityHistory(std::size_t signals, int steps);

  /// The interval ends this many audio samples before the newest one.
  [[nodiscard]] static constexpr std::int64_t latency() { return half_width - 1; }

  /// As if the signals had always had this value.
  void fill(std::span<const float> values);
  /// The next audio sample.
  void push(std::span<const float> values);

  /// What the signals change from half a step before the beginning of a step to half a step after it.
  /// @param step     of the interval, from 0 on
  /// @param changes  [signals]
  void changes(int step, std::span<float> changes) const;

  [[nodiscard]] std::size_t signals() const { return samples_.front().size(); }
  /// In an audio sample.
  [[nodiscard]] int steps() const { return static_cast<int>(weights_.size()); }
  /// How many audio samples are kept.
  [[nodiscard]] static constexpr int length() { return 2 * half_width + 1; }
  /// Of the kept audio samples, oldest first, in the changes of a step.
  [[nodiscard]] std::span<const float> weights(int step) const { return weights_[step]; }
  /// One of the kept audio samples, from 0 for the oldest one: [signals].
  [[nodiscard]] std::span<const float> sample(int place) const { return samples_[place]; }
  /// The number of the oldest kept audio sample. Others follow it. No two samples of this object ever have the same
  /// number, so a copy of it knows which ones are new.
  [[nodiscard]] std::int64_t oldest() const { return oldest_; }

  /// All samples, oldest first: [samples x signals].
  [[nodiscard]] std::vector<double> samples() const;
  void restore(std::span<const double> samples);

 private:
  static constexpr int half_width = 8;  ///< of the sinc, audio samples

  std::vector<std::vector<float>> weights_;  // [steps][samples]
  std::deque<std::vector<float>> samples_;   // oldest first
  std::int64_t oldest_ = 0;
};

}  // namespace idiophone::waves
