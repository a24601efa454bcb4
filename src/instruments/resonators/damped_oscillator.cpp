#include "idiophone/instruments/resonators/damped_oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone::resonators {

namespace {

/// Integrals over an audio sample of exp(x (1 - s)) and (2 s - 1) exp(x (1 - s)), s from 0 to 1.
std::pair<Complex, Complex> integrals(Complex x) {
  if (std::abs(x) < 0.1) {  // the closed form would lose digits
    Complex mean = 0.0, slope = 0.0, power = 1.0;
    for (int n = 0; n < 12; ++n) {  // x^n/(n + 1)! and -n x^n/(n + 2)!
      mean += power / (n + 1.0);
      slope -= power * (n / ((n + 1.0) * (n + 2.0)));
      power *= x / (n + 1.0);
    }
    return {mean, slope};
  }
  const Complex mean = (std::exp(x) - 1.0) / x;
  return {mean, 2.0 * (mean - 1.0) / x - mean};
}

}  // namespace

DampedOscillator::DampedOscillator(double frequency, double decay_rate) : decay(decay_rate) {
  const double angular = 2.0 * std::numbers::pi * frequency;
  damped = std::sqrt(std::max(angular * angular - decay * decay, 0.0));
}

OscillatorStep DampedOscillator::step(double duration) const {
  const Complex turn = std::exp(exponent() * duration);
  const Complex whole = (turn - 1.0) / exponent();                    // integral of exp(x (duration - t)) over the step
  const Complex last = (whole - duration) / (exponent() * duration);  // the same with the weight t/duration
  return {.turn = turn, .first = whole - last, .last = last};
}

Resonator::Resonator(const DampedOscillator& oscillator, int rate)
    : velocity(oscillator.velocity()), displacement(oscillator.displacement()) {
  const Complex exponent(-oscillator.decay / rate, oscillator.damped / rate);
  const auto [mean, slope] = integrals(exponent);
  turn = std::exp(exponent);
  by_mean = mean / static_cast<double>(rate);
  by_slope = slope / static_cast<double>(rate);
}

}  // namespace idiophone::resonators
