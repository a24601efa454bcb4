#pragma once
// Damped oscillators under forces, stepped exactly.

#include <span>
#include <vector>

namespace idiophone::modal_bodies {

/// How an oscillator q'' + 2 a q' + w^2 q = w^2 s moves in a step dt. With c = exp(-a dt) cos(w_d dt) and
/// e = exp(-2 a dt),
///   q_{n+1} - 2 c q_n + e q_{n-1} = (1 - 2 c + e) s_n
/// is exact for free vibrations and for a constant s, and of second order for one that changes, since s_n is in the
/// middle of the three times (Gautschi, Numerische Mathematik 3, 1961). It is stable for any w dt. The rate
/// r_{n+1/2} = (q_{n+1} - q_n)/dt takes the place of q_{n-1}:
///   r_{n+1/2} = keep r_{n-1/2} + pull (s_n - q_n),  keep = e, pull = (1 - 2 c + e)/dt.
struct OscillatorStep {
  double keep = 1.0;
  double pull = 0.0;  ///< 1/s

  OscillatorStep() = default;
  /// @param frequency  w without damping, rad/s
  /// @param decay      a, 1/s
  OscillatorStep(double frequency, double decay, double step);
};

/// Rate of an oscillator in the first step, (q_1 - q_0)/dt: exact for a constant s.
/// @param rate  q' at time 0
[[nodiscard]] double first_rate(double frequency, double decay, double step, double place, double rate, double target);

/// Lengths of two steps, one after the other, s; `before` is zero in the first step.
struct StepLengths {
  double before;
  double now;
};

/// Rate of an oscillator over a step that is longer or shorter than the one before, exact for a constant s.
/// @param rate  over the step before; q' in the first step
[[nodiscard]] double rate_of_other_step(double frequency, double decay, const StepLengths& lengths, double place,
                                        double rate, double target);

/// q' at t_n from the mean of the rates before and after: exact for free vibrations without damping.
[[nodiscard]] double rate_correction(double frequency, double step);

}  // namespace idiophone::modal_bodies
