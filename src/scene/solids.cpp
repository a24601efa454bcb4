#include "idiophone/scene/solids.hpp"

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

Solids::Solids(const Scene& scene)
    : bodies(scene.bodies),
      materials(scene.materials),
      pulses(scene.pulses),
      plucks(scene.plucks),
      obstacles(scene.obstacles),
      contacts(scene.contacts),
      gravity(scene.gravity),
      max_frequency(scene.audio.max_frequency) {}

Solids Solids::alone(std::size_t body) const {
  Solids result = *this;
  result.bodies = bodies.subspan(body, 1);
  result.pulses = {};
  result.plucks = {};
  result.contacts = {};
  return result;
}

}  // namespace idiophone::scene
