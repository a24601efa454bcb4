#include "map_loudness.hpp"

#include <cmath>

namespace idiophone::engines {

/// An impulse J along n gives a mode the velocity J phi.n, and n is any direction: the mean of (phi.n)^2 is phi^2/3.
double loudness_of(const sound_maps::SoundMap& map) {
  const std::size_t directions = map.sphere.direction.size();
  double sum = 0.0;
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    double shape = 0.0, pressure = 0.0;
    for (const float phi : map.shape_of(mode)) {
      shape += static_cast<double>(phi) * phi;
    }
    for (std::size_t i = 0; i < directions; ++i) {
      pressure += std::norm(map.sphere.pressure[mode * directions + i]) / static_cast<double>(directions);
    }
    sum += 0.5 * pressure * shape / (3.0 * static_cast<double>(map.vertices.size()));
  }
  return map.sphere.distance * std::sqrt(sum);
}

}  // namespace idiophone::engines
