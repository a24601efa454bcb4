#pragma once
// One damped oscillator as a complex number z that a force F drives: z' = (i w_d - d) z + F. All voices, maps and
// exports that sound by modes take its formulas from here.

#include <complex>

namespace idiophone::resonators {

using Complex = std::complex<double>;

/// A step of an oscillator: z becomes turn z + first F(begin) + last F(end), exact for a force that is linear in the
/// step.
struct OscillatorStep {
  Complex turn;
  Complex first, last;  ///< s
};

/// An oscillator of the frequency w_d = sqrt(w^2 - d^2).
struct DampedOscillator {
  /// @param frequency  without damping, Hz
  /// @param decay      d, of the amplitude, 1/s
  DampedOscillator(double frequency, double decay);

  /// Whether it vibrates at all; what creeps back does not sound.
  [[nodiscard]] bool oscillates() const { return damped > 0.0; }

  /// The velocity is Re(velocity() z): 1 + i d/w_d.
  [[nodiscard]] Complex velocity() const { return {1.0, decay / damped}; }

  /// The displacement is Re(displacement() z): -i/w_d, s.
  [[nodiscard]] Complex displacement() const { return {0.0, -1.0 / damped}; }

  /// i w_d - d, 1/s.
  [[nodiscard]] Complex exponent() const { return {-decay, damped}; }

  /// z that a constant force of 1 holds still: -1/exponent(), s.
  [[nodiscard]] Complex static_state() const { return -1.0 / exponent(); }

  /// What is added to static_state() F for each N/s by which the force rises: -1/exponent()^2, s^2. Both together are
  /// the state of a mode that follows a slow force. It does not sound (docs/method/sound_map.md).
  [[nodiscard]] Complex rising_state() const { return -1.0 / (exponent() * exponent()); }

  /// @param duration  of the step, s
  [[nodiscard]] OscillatorStep step(double duration) const;

  double damped;  ///< w_d, rad/s; 0 if it does not oscillate
  double decay;   ///< 1/s
};

/// The same for an audio sample and a force as resonators::ForcePiece has it: z becomes
/// turn z + phi (by_mean mean + by_slope slope).
struct Resonator {
  /// @param oscillator  that oscillates
  Resonator(const DampedOscillator& oscillator, int rate);
  /// A mode that is left out.
  Resonator() = default;

  Complex turn = 0.0;
  Complex by_mean = 0.0, by_slope = 0.0;  // s
  Complex velocity = 0.0;                 ///< DampedOscillator::velocity()
  Complex displacement = 0.0;             ///< DampedOscillator::displacement()
};

}  // namespace idiophone::resonators
