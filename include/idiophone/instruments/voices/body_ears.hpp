#pragma once
// One body's sound on its way to a head, and at its ears.

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/instruments/voices/arrivals.hpp"
#include "idiophone/instruments/voices/head_filter.hpp"

namespace idiophone::voices {

/// The responses of the head follow the direction of the body: they cross over to those of another one.
class BodyEars {
 public:
  /// @param longest_delay  audio samples
  /// @param responses      [2 x taps] of the direction at first
  BodyEars(double longest_delay, std::vector<double> responses);

  /// Whether it still crosses over to the last direction.
  [[nodiscard]] bool turns() const { return left_ > 0; }

  /// Begins to cross over to the responses of a direction, if they are others. Not while it turns.
  void turn_to(std::vector<double> responses);

  /// As Arrivals::add(). @param pressure  at the middle of the head without the head, Pa
  void add(std::int64_t sample, double pressure, double delay) { arrivals_.add(sample, pressure, delay); }

  /// Adds what both ears hear in the audio samples from `first` on, [samples x 2]; to be called for all, in order.
  void hear(std::int64_t first, std::span<double> sound);

 private:
  Arrivals arrivals_;
  std::vector<double> responses_;  // that are heard, or come next
  HeadFilter filter_;
  std::int64_t left_ = 0;  // audio samples of the change
  std::vector<double> arrived_;
};

}  // namespace idiophone::voices
