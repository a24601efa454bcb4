#pragma once
// The sound of a force on a body, sample by sample, from its sound map.

#include <span>
#include <vector>

#include "idiophone/instruments/resonators/smooth_rise.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

struct Resonance;

/// The sound of modes that only follow a slow force, which nobody hears (docs/method/sound_map.md).
struct Following {
  double by_force = 0.0;           ///< Pa for 1 N
  double by_rise = 0.0;            ///< Pa for 1 N/s of resonators::SmoothRise
  double angular_frequency = 1.0;  ///< of the lowest mode, rad/s
};

/// The modes of a body, driven at one place and heard at one listener.
class Resonators {
 public:
  /// At rest. Modes from half the rate on are left out.
  /// @param participation  of a force of 1 N (modal/blow.hpp), [modes] 1/sqrt(kg)
  /// @param listener       index into SoundMap::listeners
  /// @param rate           audio samples per second
  Resonators(const sound_maps::SoundMap& map, std::span<const double> participation, std::size_t listener, int rate);

  /// The pressure of the next sample, Pa, without the delay to the listener.
  /// @param force  at this sample, N; linear between samples, zero before the first
  double step(double force);

 private:
  Resonators(const std::vector<Resonance>& modes, int rate);

  /// The numbers of one mode: z becomes turn z + first F(before) + last F(now), and Re(gain z) is heard.
  struct Mode {
    double turn_real, turn_imaginary;
    double first_real, first_imaginary;
    double last_real, last_imaginary;
    double gain_real, gain_imaginary;
    double real = 0.0, imaginary = 0.0;  // of z
  };

  std::vector<Mode> modes_;
  Following following_;
  resonators::SmoothRise rise_;
  double force_ = 0.0;  // at the sample before
};

}  // namespace idiophone::sound_maps
