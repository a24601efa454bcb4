#pragma once
// The sound of a blow on a body, from its sound map (van den Doel and Pai 1996; docs/method/sound_map.md).

#include <functional>
#include <vector>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// A force at a point of the surface.
struct Blow {
  Vector3 at = Vector3::Zero();              ///< the nearest point of the surface is struck, m
  Vector3 direction = -Vector3::UnitZ();     ///< of the force; unit vector
  std::function<double(double time)> force;  ///< N, at a time in s; zero before 0 and from `duration` on
  double duration = 0.0;                     ///< s
};

/// How far a force of 1 N at a place drives each mode: phi . direction, [modes] 1/sqrt(kg).
/// @param at  the nearest point of the surface is taken, m
[[nodiscard]] std::vector<double> participation(const sound_maps::SoundMap& map, const Vector3& at,
                                                const Vector3& direction);

/// Into the body, at right angles to the surface at its point nearest to a place: a unit vector, -z for a triangle
/// without an area.
/// @param at  m
[[nodiscard]] Vector3 inward_normal(const sound_maps::SoundMap& map, const Vector3& at);

/// Sound pressure at a listener, Pa. Modes above half the rate are left out.
/// @param listener  index into SoundMap::listeners
/// @param rate      audio samples per second
[[nodiscard]] std::vector<double> sound_of(const Blow& blow, const sound_maps::SoundMap& map, std::size_t listener,
                                           int rate, std::size_t samples);

}  // namespace idiophone::sound_maps
