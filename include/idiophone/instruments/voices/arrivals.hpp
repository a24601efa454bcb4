#pragma once
// Sound on its way from one body to one receiver.

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

  /// What arrives at a sample. It is then forgotten; to be called for each sample, in order.
  double take(std::int64_t sample);

 private:
  const receivers::Spreading* spreading_;
  double longest_delay_;
  std::int64_t silent_from_ = 0;  // audio sample from which on nothing arrives
  std::vector<double> ring_;      // of entries, a power of two long
};

}  // namespace idiophone::voices
