#include "idiophone/scene/solids.hpp"

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

Solids::Solids(const Scene& scene)
    : bodies(scene.bodies),
      materials(scene.materials),
      pulses(scene.pulses),
      plucks(scene.plucks),
      winds(scene.winds),
      bows(scene.bows),
      obstacles(scene.obstacles),
      contacts(scene.contacts),
      joints(scene.joints),
      gauges(scene.gauges),
      gravity(scene.gravity),
      air_density(scene.radiation.air.density),
      max_frequency(scene.audio.max_frequency) {}

Solids Solids::alone(std::size_t body) const {
  Solids result = *this;
  result.bodies = bodies.subspan(body, 1);
  result.pulses = {};
  result.plucks = {};
  result.winds = {};
  result.bows = {};
  result.contacts = {};
  result.joints = {};
  result.gauges = {};
  return result;
}

}  // namespace idiophone::scene
