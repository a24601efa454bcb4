#pragma once
// The straight ways from triangles to a receiver (O'Brien 2001, section 3.3 and eq. 11).

#include <vector>

#include "idiophone/surface/emission.hpp"
#include "idiophone/types.hpp"

namespace idiophone::radiation {

/// The air, and the clock that delays are counted with.
struct Medium {
  double speed = 343.0;  ///< of sound, m/s
  int rate = 44100;      ///< audio samples per second

  /// Audio samples in which sound travels a metre.
  [[nodiscard]] double samples_per_metre() const { return rate / speed; }

  /// @throws std::invalid_argument when speed or rate is not positive.
  void validate() const;
};

/// A point that hears, at one moment.
struct ReceiverState {
  Vector3 position = Vector3::Zero();  ///< m
  Vector3 velocity = Vector3::Zero();  ///< m/s, slower than sound; steady while the sound is on its way
  Vector3 axis = Vector3::UnitZ();     ///< unit vector: where a directional microphone looks
  double directivity = 0.0;            ///< d of its sensitivity 1 - d + d cos(angle off the axis); 0.5: a cardioid
  double gain = 1.0;                   ///< of all that it hears
};

/// Receivers farther away than this are a mistake; it bounds the memory of what is still on its way, m.
inline constexpr double longest_distance = 100e3;

/// Receivers nearer to a triangle's centre than this are taken to be this far away, m. Nothing is infinite then; no
/// model means anything within a triangle's own size.
inline constexpr double smallest_distance = 1e-3;

/// From each triangle of an emission to where the receiver is when its sound arrives.
struct Paths {
  std::vector<double> distance;  ///< [triangles of the emission] R, at least smallest_distance, m
  std::vector<double> cosine;    ///< likewise; of the angle between the triangle's normal and the way to the receiver
  std::vector<double> delay;     ///< likewise; travel time R/c (eq. 11) in audio samples
  std::vector<double> gain;      ///< likewise; of the receiver in the direction that the sound comes from
};

/// Solves |x + v t - y| = c t for each triangle's centre y: exact, Doppler shift included, for a receiver at x with the
/// steady velocity v.
/// @param emission  arrays padded to a multiple of 8 triangles
/// @param paths     as long as the emission's arrays; what was in it is lost
/// @throws std::invalid_argument when the emission is not padded
void find_paths(const surface::Emission& emission, const ReceiverState& receiver, const Medium& air, Paths& paths);

}  // namespace idiophone::radiation
