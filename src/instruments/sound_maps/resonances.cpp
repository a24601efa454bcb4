#include "resonances.hpp"

#include <cmath>

#include "idiophone/instruments/sound_maps/resonators.hpp"

namespace idiophone::sound_maps {

std::vector<Resonance> resonances(const sound_maps::SoundMap& map, std::span<const double> participation,
                                  std::size_t listener, int rate) {
  std::vector<Resonance> found;
  for (std::size_t mode = 0; mode < map.modes() && map.frequency[mode] < 0.5 * rate; ++mode) {
    const resonators::DampedOscillator oscillator(map.frequency[mode], map.decay(mode));
    if (oscillator.oscillates()) {
      found.push_back(
          {oscillator, participation[mode] * map.listeners[listener].pressure[mode] * oscillator.velocity()});
    }
  }
  return found;
}

Following following(const std::vector<Resonance>& modes) {
  Following sums;
  for (const Resonance& mode : modes) {
    sums.by_force += (mode.gain * mode.oscillator.static_state()).real();
    sums.by_rise += (mode.gain * mode.oscillator.rising_state()).real();
  }
  sums.angular_frequency = modes.empty() ? 1.0 : modes.front().oscillator.damped;
  return sums;
}

Resonators::Resonators(const sound_maps::SoundMap& map, std::span<const double> participation, std::size_t listener,
                       int rate)
    : Resonators(resonances(map, participation, listener, rate), rate) {}

Resonators::Resonators(const std::vector<Resonance>& modes, int rate)
    : following_(following(modes)), rise_(following_.angular_frequency, 1.0 / rate) {
  for (const Resonance& mode : modes) {
    const resonators::OscillatorStep step = mode.oscillator.step(1.0 / rate);
    modes_.push_back({step.turn.real(), step.turn.imag(), step.first.real(), step.first.imag(), step.last.real(),
                      step.last.imag(), mode.gain.real(), mode.gain.imag()});
  }
}

double Resonators::step(double force) {
  constexpr double smallest = 1e-30;  // smaller ones would become denormal, which is slow
  rise_.advance(force_, force);
  double sound = -following_.by_force * force - following_.by_rise * rise_.at(force);
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
