#pragma once
// A sound map that is loud at all pitches.

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// A square sheet of 0.2 m with some modes, two listeners, and a sphere on which mode n has the pattern of a dipole.
inline SoundMap sheet(const std::string& body = "sheet") {
  SoundMap map;
  map.body = body;
  map.kind = "plate";
  map.mass = 1.0;
  map.vertices = {{0, 0, 0}, {0.2, 0, 0}, {0.2, 0.2, 0}, {0, 0.2, 0}, {0.1, 0.1, 0}};
  map.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  map.centre = {0.1, 0.1, 0.0};
  map.sphere.rings = 4;
  map.sphere.azimuths = 8;
  const std::array<std::array<double, 2>, 4> gauss = {{{0.861136311594052575, 0.347854845137453857},
                                                       {0.339981043584856265, 0.652145154862546143},
                                                       {-0.339981043584856265, 0.652145154862546143},
                                                       {-0.861136311594052575, 0.347854845137453857}}};
  for (const auto& [z, weight] : gauss) {
    for (int a = 0; a < 8; ++a) {
      const double angle = std::numbers::pi / 4.0 * a;
      const double radius = std::sqrt(1.0 - z * z);
      map.sphere.direction.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
      map.sphere.weight.push_back(weight * std::numbers::pi / 4.0);
    }
  }
  map.listeners = {{.name = "left", .position = {0, 0, 1}, .delay = 0.0029, .pressure = {}},
                   {.name = "right", .position = {0.2, 0, 1}, .delay = 0.0031, .pressure = {}}};
  for (int mode = 0; mode < 45; ++mode) {
    const double n = mode + 1.0;
    map.frequency.push_back(115.0 * n * std::sqrt(n) + (mode < 29 ? 0.0 : 2e4));  // up to 18 kHz; others are left out
    map.material_decay.push_back(4.0 + n);
    map.radiation_decay.push_back(0.5);
    for (int vertex = 0; vertex < 5; ++vertex) {
      const auto x = static_cast<float>(std::sin(n * (vertex + 1.3)));
      map.shape.insert(map.shape.end(), {0.1F * x, 0.0F, 3.0F * x});
    }
    map.listeners[0].pressure.emplace_back(0.02 * n, -0.3);
    map.listeners[1].pressure.emplace_back(-0.01 * n, 0.2);
    for (const Vector3& direction : map.sphere.direction) {
      map.sphere.pressure.emplace_back(n * direction.z(), 0.5 * direction.x());
    }
  }
  return map;
}

}  // namespace idiophone::sound_maps
