#pragma once
// Sound on its way from bodies to one receiver.

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/air/receivers/spreading.hpp"

namespace idiophone::voices {

/// A ring of entries to which sound is added when it is emitted, as in an accumulation buffer. The delay can change
/// from sample to sample, which gives the Doppler shift.
class Arrivals {
 public:
  /// Delays from nearest() to `longest_delay` are possible, audio samples.
  explicit Arrivals(double longest_delay);

  /// The shortest possible delay, audio samples: a sample depends on what arrives shortly after it, too.
  [[nodiscard]] static double nearest();

  /// What is emitted at a sample arrives `delay` samples later. Delays out of range are limited to it.
  void add(std::int64_t sample, double pressure, double delay);

  /// Adds what arrives at the samples from `first` on to every `channels`-th number. It is then forgotten; to be called
  /// for all samples, in order. What is emitted may be at most ResonatorBank::most_samples ahead of `first`.
  void take(std::int64_t first, std::span<double> sound, std::size_t channels = 1);

 private:
  void take_some(std::int64_t first, std::span<double> sound);

  const receivers::Spreading* spreading_;
  double nearest_ = nearest(), longest_delay_;
  std::int64_t silent_from_ = 0;  // audio sample from which on nothing arrives
  std::vector<double> ring_;      // of entries, a power of two long
  std::vector<double> near_;      // entries of one kind about the samples that are taken
};

}  // namespace idiophone::voices
