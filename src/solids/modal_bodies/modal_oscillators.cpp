#include "modal_oscillators.hpp"

#include <cmath>

namespace idiophone::modal_bodies {

namespace {

/// exp(-a t) times the solutions of the free oscillator that start with (1, 0) and with (0, 1).
struct FreeMotion {
  double cosine;  ///< exp(-a t) (cos(w_d t) + a/w_d sin(w_d t))
  double sine;    ///< exp(-a t) sin(w_d t)/w_d, s

  FreeMotion(double frequency, double decay, double time) {
    const double square = frequency * frequency - decay * decay;
    const double damped = std::sqrt(std::abs(square));
    const double angle = damped * time;
    const double fall = std::exp(-decay * time);
    if (square > 0) {
      sine = fall * std::sin(angle) / damped;
      cosine = fall * std::cos(angle) + decay * sine;
    } else {
      sine = damped > 0 ? fall * std::sinh(angle) / damped : fall * time;
      cosine = fall * std::cosh(angle) + decay * sine;
    }
  }
};

}  // namespace

OscillatorStep::OscillatorStep(double frequency, double decay, double step) : keep(std::exp(-2 * decay * step)) {
  // 1 - 2 c + e = (1 - sqrt(e))^2 + 2 sqrt(e) (1 - cos(w_d dt)), without cancellation.
  const double square = frequency * frequency - decay * decay;
  const double half = std::sqrt(std::abs(square)) * step / 2;
  const double root = std::exp(-decay * step);
  const double lost = -std::expm1(-decay * step);
  const double turned = square > 0 ? std::sin(half) * std::sin(half) : -std::sinh(half) * std::sinh(half);
  pull = (lost * lost + 4 * root * turned) / step;
}

double first_rate(double frequency, double decay, double step, double place, double rate, double target) {
  const FreeMotion free(frequency, decay, step);
  return ((place - target) * (free.cosine - 1) + rate * free.sine) / step;
}

double rate_of_other_step(double frequency, double decay, const StepLengths& lengths, double place, double rate,
                          double target) {
  if (lengths.before == 0.0) {
    return first_rate(frequency, decay, lengths.now, place, rate, target);
  }
  // The rate now, which takes the oscillator back to where it was a step ago.
  const FreeMotion back(frequency, decay, -lengths.before);
  const double here = place - target;
  const double rate_now = ((1 - back.cosine) * here - lengths.before * rate) / back.sine;
  return first_rate(frequency, decay, lengths.now, place, rate_now, target);
}

double rate_correction(double frequency, double step) {
  const double angle = frequency * step;
  return angle > 0 ? angle / std::sin(angle) : 1.0;
}

}  // namespace idiophone::modal_bodies
