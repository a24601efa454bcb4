#pragma once
// Maps of surfaces whose modes are formulas.

#include <functional>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "vibrating_solid.hpp"

namespace idiophone::sound_maps {

/// Displacement at a place of the surface for unit modal mass, 1/sqrt(kg).
using Shape = std::function<Vector3(const Vector3& place)>;

/// A map without sound, with one mode of this shape at each frequency.
inline sound_maps::SoundMap map_of(const radiation::Solid& solid, const Shape& shape, std::vector<double> frequencies) {
  sound_maps::SoundMap map;
  map.mass = 1.0;
  map.air_density = radiation::air_density;
  map.air_speed = radiation::test_air.speed;
  map.frequency = std::move(frequencies);
  map.material_decay.assign(map.frequency.size(), 0.0);
  map.radiation_decay.assign(map.frequency.size(), 0.0);
  map.vertices = solid.vertices;
  map.triangles = solid.triangles;
  for (std::size_t mode = 0; mode < map.frequency.size(); ++mode) {
    for (const Vector3& vertex : solid.vertices) {
      const Vector3 displacement = shape(vertex);
      map.shape.insert(map.shape.end(), displacement.begin(), displacement.end());
    }
  }
  return map;
}

}  // namespace idiophone::sound_maps
