#pragma once
// What a room makes of the sound that leaves in some directions, once it has had more reflections than those that are
// computed one by one.

#include <array>
#include <cstdint>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/radiation_section.hpp"

namespace idiophone::propagation {

/// A number for each octave band from scene::lowest_octave to 16 kHz.
using LateBands = std::array<double, 8>;

/// Stands for all paths that leave within its part of the sphere: 4 pi/K of K directions.
struct LateDirection {
  Vector3 direction;    ///< unit vector
  double distance;      ///< way after which a path has had half a reflection more than the order of the images, m
  LateBands remaining;  ///< energy that walls and air have left of it by then, 0 to 1
  double paths;         ///< that arrive in a second by then: 4 pi R^2 c/(K V), 1/s
};

/// Directions that are spread evenly. Up to the order of the images, a path loses energy by the walls that it meets in
/// its direction.
/// @throws std::logic_error without a room
[[nodiscard]] std::vector<LateDirection> late_directions(const scene::Radiation& radiation);

/// By which the energy decays from then on, 1/s: Room::decay_rate(), and absorption by the air.
[[nodiscard]] LateBands late_decay(const scene::Radiation& radiation);

/// The response that takes the sound of one path in this direction (with the level of its distance, before losses) to
/// the sound of all that follows: noise whose power begins with `paths` times `remaining` and decays with `decay`, down
/// to -60 dB in all bands.
/// @param decay  1/s
/// @param rate   audio samples per second
/// @param seed   other seeds give other noise, without correlation
[[nodiscard]] std::vector<double> late_tail(const LateDirection& direction, const LateBands& decay, int rate,
                                            std::uint64_t seed);

}  // namespace idiophone::propagation
