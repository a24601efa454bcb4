#pragma once
// What a score's event does to a body: forces at fixed points over time. They do not depend on what computes the sound.

#include <cstdint>
#include <vector>

#include "idiophone/instruments/score/score.hpp"

namespace idiophone::resonators {

/// Force in one audio sample: mean + slope (2 s - 1), where s goes from 0 to 1 in the sample. N
struct ForcePiece {
  double mean = 0.0;
  double slope = 0.0;
  double begin = 0.0;  ///< the force itself at s = 0; a force that is not linear differs from mean - slope
  double rise = 0.0;   ///< by which it grows in a sample, smoothed (add_rise())
};

/// A force that is linear in the sample. @param begin, end  N
[[nodiscard]] constexpr ForcePiece linear_piece(double begin, double end) {
  return {.mean = 0.5 * (begin + end), .slope = 0.5 * (end - begin), .begin = begin};
}

/// A force from its first audio sample on.
using ForceCurve = std::vector<ForcePiece>;

/// A force at one place.
struct PointForce {
  std::int64_t start = 0;               ///< audio sample
  Vector3 at = Vector3::Zero();         ///< m
  Vector3 direction = Vector3::Zero();  ///< by which the curve is multiplied
  ForceCurve force{};
};

/// The forces of a blow, a force or a stroke. A stroke consists of forces at points along its way, each of which acts
/// while the contact is near.
/// @param start  audio sample of the event
/// @param seed   of roughness
/// @return none for events of other kinds
[[nodiscard]] std::vector<PointForce> point_forces(const score::ScoreEvent& event, std::int64_t start,
                                                   std::uint64_t seed, int rate);

}  // namespace idiophone::resonators
