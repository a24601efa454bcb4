#include "idiophone/scene/alone.hpp"

namespace idiophone::scene {

Scene alone(Scene scene, std::size_t body) {
  scene.bodies = {scene.bodies[body]};
  scene.recorded_bodies.clear();
  scene.pulses.clear();
  scene.plucks.clear();
  scene.contacts.clear();
  return scene;
}

}  // namespace idiophone::scene
