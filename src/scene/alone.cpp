#include "idiophone/scene/alone.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace idiophone::scene {

std::size_t find_body(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  std::ranges::transform(scene.bodies, std::back_inserter(names), &Body::name);
  const auto chosen = name.empty() ? names.begin() : std::ranges::find(names, name);
  if (chosen == names.end()) {
    throw std::runtime_error(
        fmt::format("there is no body '{}' in the deck; it has: {}", name, fmt::join(names, ", ")));
  }
  return chosen - names.begin();
}

Scene alone(Scene scene, std::size_t body) {
  scene.bodies = {scene.bodies[body]};
  scene.recorded_bodies.clear();
  scene.pulses.clear();
  scene.plucks.clear();
  scene.contacts.clear();
  return scene;
}

}  // namespace idiophone::scene
