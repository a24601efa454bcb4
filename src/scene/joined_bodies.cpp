#include "idiophone/scene/joined_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::scene {

Scene assembly_of(Scene scene, std::size_t body) {
  Assembly assembly(scene, body);
  scene.bodies = std::move(assembly.bodies);
  scene.joints = std::move(assembly.joints);
  scene.pulses.clear();
  scene.plucks.clear();
  scene.winds.clear();
  scene.bows.clear();
  scene.contacts.clear();
  scene.gauges.clear();
  return scene;
}

bool is_joined(std::size_t body, std::span<const Joint> joints) {
  return std::ranges::any_of(
      joints, [&](const Joint& joint) { return joint.surfaces[0].body == body || joint.surfaces[1].body == body; });
}

void refuse_joints(const Solids& solids, const std::string& work) {
  if (!solids.joints.empty()) {
    const Joint& joint = solids.joints.front();
    throw deck::DeckError(joint.where, fmt::format("joints.{}: '{}' does not know joints; use 'run', 'modes', 'map' or "
                                                   "'radiate', or leave the joints out",
                                                   joint.name, work));
  }
}

}  // namespace idiophone::scene
