#pragma once
// The straight paths from triangles to a receiver (O'Brien 2001, section 3.3 and eq. 11).

#include <vector>

#include "idiophone/air/surface/emission.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::radiation {

/// The air, and the audio rate that delays are measured in.
struct Medium {
  double speed = 343.0;  ///< of sound, m/s
  int rate = 44100;      ///< audio samples per second

  /// Audio samples that sound takes for one metre.
  [[nodiscard]] double samples_per_metre() const { return rate / speed; }

  /// @throws std::invalid_argument if the speed or the rate is not positive
  void validate() const;
};

/// A receiver at one moment.
struct ReceiverState {
  Vector3 position = Vector3::Zero();  ///< m
  Vector3 velocity = Vector3::Zero();  ///< m/s, below the speed of sound; constant during the travel time
  Vector3 axis = Vector3::UnitZ();     ///< unit vector: axis of a directional microphone
  double directivity = 0.0;            ///< d of its sensitivity 1 - d + d cos(angle off the axis); 0.5: a cardioid
  double gain = 1.0;                   ///< of the microphone
};

/// The largest distance of a receiver, m. It bounds the length of accumulation buffers.
inline constexpr double longest_distance = 100e3;

/// Smaller distances from a triangle's centre are replaced by this one, m, so that nothing is infinite. No model is
/// valid within the size of a triangle.
inline constexpr double smallest_distance = 1e-3;

/// From each triangle of an emission to where the receiver is when its sound arrives.
struct Paths {
  std::vector<double> distance;  ///< [triangles of the emission] R, at least smallest_distance, m
  std::vector<double>
      cosine;  ///< likewise; of the angle between the triangle's normal and the direction to the receiver
  std::vector<double> delay;  ///< likewise; travel time R/c (eq. 11) in audio samples
  std::vector<double> gain;   ///< likewise; the receiver's gain in the direction of the triangle
};

/// Solves |x + v t - y| = c t for each triangle's centre y: exact, Doppler shift included, for a receiver at x with the
/// steady velocity v.
/// @param emission  arrays padded to a multiple of 8 triangles
/// @param paths     overwritten; becomes as long as the emission's arrays
/// @throws std::invalid_argument if the emission is not padded
void find_paths(const surface::Emission& emission, const ReceiverState& receiver, const Medium& air, Paths& paths);

}  // namespace idiophone::radiation
