#include "resonances.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/instruments/sound_maps/resonators.hpp"

namespace idiophone::sound_maps {

std::vector<Resonance> resonances(const sound_maps::SoundMap& map, std::span<const double> participation,
                                  std::size_t listener, int rate) {
  std::vector<Resonance> found;
  for (std::size_t mode = 0; mode < map.modes() && map.frequency[mode] < 0.5 * rate; ++mode) {
    const double decay = map.decay(mode);
    const double angular = 2.0 * std::numbers::pi * map.frequency[mode];
    const double damped = std::sqrt(std::max(angular * angular - decay * decay, 0.0));
    if (damped > 0.0) {  // what creeps back does not sound
      const std::complex<double> velocity(1.0, decay / damped);
      found.push_back({{-decay, damped}, participation[mode] * map.listeners[listener].pressure[mode] * velocity});
    }
  }
  return found;
}

ModeStep::ModeStep(std::complex<double> exponent, double step) : turn(std::exp(exponent * step)) {
  const std::complex<double> whole = (turn - 1.0) / exponent;  // integral of exp(x (step - t)) over the step
  last = (whole - step) / (exponent * step);                   // the same with the weight t/step
  first = whole - last;
}

Resonators::Resonators(const sound_maps::SoundMap& map, std::span<const double> participation, std::size_t listener,
                       int rate) {
  for (const Resonance& resonance : resonances(map, participation, listener, rate)) {
    const ModeStep step(resonance.exponent, 1.0 / rate);
    modes_.push_back({step.turn.real(), step.turn.imag(), step.first.real(), step.first.imag(), step.last.real(),
                      step.last.imag(), resonance.gain.real(), resonance.gain.imag()});
  }
}

double Resonators::step(double force) {
  constexpr double smallest = 1e-30;  // smaller ones would become denormal, which is slow
  double sound = 0.0;
  for (Mode& mode : modes_) {
    const double real = mode.turn_real * mode.real - mode.turn_imaginary * mode.imaginary + mode.first_real * force_ +
                        mode.last_real * force;
    const double imaginary = mode.turn_real * mode.imaginary + mode.turn_imaginary * mode.real +
                             mode.first_imaginary * force_ + mode.last_imaginary * force;
    mode.real = std::abs(real) < smallest ? 0.0 : real;
    mode.imaginary = std::abs(imaginary) < smallest ? 0.0 : imaginary;
    sound += mode.gain_real * mode.real - mode.gain_imaginary * mode.imaginary;
  }
  force_ = force;
  return sound;
}

}  // namespace idiophone::sound_maps
