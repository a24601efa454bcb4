#pragma once
// How fast a force rises. Modes far above its frequencies follow it without a sound (docs/method/sound_map.md).

#include "idiophone/instruments/resonators/damped_oscillator.hpp"
#include "idiophone/instruments/resonators/force_piece.hpp"

namespace idiophone::resonators {

/// Rate of change of a force that passed a low-pass of first order, because modes do not follow what is fast.
class SmoothRise {
 public:
  /// @param angular_frequency  of the low-pass, rad/s: that of the lowest mode
  /// @param step               s
  SmoothRise(double angular_frequency, double step);

  /// N/s, at a time when the force is that.
  [[nodiscard]] double at(double force) const { return angular_frequency_ * (force - smooth_); }

  /// A step in which the force is linear.
  void advance(double begin, double end);

 private:
  double angular_frequency_;
  OscillatorStep step_;
  double smooth_ = 0.0;  // N
};

/// From the end of a force until its rise is negligible, audio samples.
/// @param angular_frequency  of the low-pass, rad/s
[[nodiscard]] std::size_t samples_of_rise(double angular_frequency, int rate);

/// Fills in ForcePiece::rise, and adds samples without a force until it is negligible.
/// @param angular_frequency  of the low-pass, rad/s
void add_rise(ForceCurve& force, double angular_frequency, int rate);

}  // namespace idiophone::resonators
