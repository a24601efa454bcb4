#pragma once
// The modes of a sound map as resonators at one listener.

#include <complex>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/damped_oscillator.hpp"
#include "idiophone/instruments/sound_maps/resonators.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// What a force on a mode gives at a listener: Re(gain z) of an oscillator, less what it does when it only follows the
/// force.
struct Resonance {
  resonators::DampedOscillator oscillator;
  std::complex<double> gain;  ///< complex pressure for z = 1
};

/// Of all modes together.
[[nodiscard]] Following following(const std::vector<Resonance>& modes);

/// The modes below half the rate that vibrate at all.
/// @param participation  [modes] of the force, 1/sqrt(kg)
[[nodiscard]] std::vector<Resonance> resonances(const sound_maps::SoundMap& map, std::span<const double> participation,
                                                std::size_t listener, int rate);

}  // namespace idiophone::sound_maps
