#pragma once
// The modes of a sound map as resonators at one listener.

#include <complex>
#include <span>
#include <vector>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// What a force on a mode gives at a listener: Re(gain z), where z' = exponent z + F.
struct Resonance {
  std::complex<double> exponent;  ///< i w_d - d, 1/s
  std::complex<double> gain;      ///< complex pressure for z = 1
};

/// The modes below half the rate that vibrate at all.
/// @param participation  [modes] of the force, 1/sqrt(kg)
[[nodiscard]] std::vector<Resonance> resonances(const sound_maps::SoundMap& map, std::span<const double> participation,
                                                std::size_t listener, int rate);

/// A step of a mode: z becomes turn z + first F(begin) + last F(end), exact for a force that is linear in the step.
struct ModeStep {
  /// @param step  s
  ModeStep(std::complex<double> exponent, double step);

  std::complex<double> turn;
  std::complex<double> first, last;  ///< s
};

}  // namespace idiophone::sound_maps
