#pragma once
// The sound of a blow on a body, from its sound map (van den Doel and Pai 1996; docs/method/sound_map.md).

#include <functional>
#include <limits>
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

/// A point of a triangle of a map's surface.
struct SurfacePoint {
  std::size_t triangle = 0;
  Vector3 weights = Vector3::Zero();                          ///< linear, of its three corners
  double distance = std::numeric_limits<double>::infinity();  ///< from the place that was asked for, m
};

/// The point of the surface that is nearest to a place, m. Looks at all triangles: see SurfaceSearch for many places.
[[nodiscard]] SurfacePoint nearest_point(const SoundMap& map, const Vector3& place);

/// How far a force of 1 N at a point drives each mode: phi . direction, [modes] 1/sqrt(kg).
[[nodiscard]] std::vector<double> participation(const SoundMap& map, const SurfacePoint& point,
                                                const Vector3& direction);
/// The same at a place.
/// @param at  the nearest point of the surface is taken, m
[[nodiscard]] std::vector<double> participation(const SoundMap& map, const Vector3& at, const Vector3& direction);

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
