#include "idiophone/scene/joined_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"

namespace idiophone::scene {

Scene assembly_of(Scene scene, std::size_t body) {
  DisjointSets tied(scene.bodies.size());
  for (const Joint& joint : scene.joints) {
    tied.join(static_cast<Index>(joint.surfaces[0].body), static_cast<Index>(joint.surfaces[1].body));
  }
  const auto is_part = [&](std::size_t other) {
    return tied.root(static_cast<Index>(other)) == tied.root(static_cast<Index>(body));
  };
  std::map<std::size_t, std::size_t> places = {{body, 0}};  // of the parts, among the parts
  std::vector<Body> bodies = {scene.bodies[body]};
  for (std::size_t other = 0; other < scene.bodies.size(); ++other) {
    if (other != body && is_part(other)) {
      places.emplace(other, bodies.size());
      bodies.push_back(scene.bodies[other]);
    }
  }
  scene.bodies = std::move(bodies);
  std::erase_if(scene.joints, [&](const Joint& joint) { return !places.contains(joint.surfaces[0].body); });
  for (Joint& joint : scene.joints) {
    for (JoinedSurface& surface : joint.surfaces) {
      surface.body = places.at(surface.body);
    }
  }
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
    throw deck::DeckError(joint.where, fmt::format("joints.{}: '{}' does not know joints; use 'run' or 'modes', or "
                                                   "leave the joints out",
                                                   joint.name, work));
  }
}

}  // namespace idiophone::scene
