#pragma once
// What a score's event does to a body: forces at fixed points over time. They do not depend on what computes the sound.

#include <cstdint>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/instruments/resonators/force_piece.hpp"

namespace idiophone::score {
struct ScoreEvent;
}

namespace idiophone::resonators {

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
