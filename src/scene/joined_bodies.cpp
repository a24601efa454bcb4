#include "idiophone/scene/joined_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"

namespace idiophone::scene {

std::vector<std::vector<std::size_t>> assemblies(const Scene& scene) {
  DisjointSets tied(scene.bodies.size());
  for (const Joint& joint : scene.joints) {
    tied.join(static_cast<Index>(joint.surfaces[0].body), static_cast<Index>(joint.surfaces[1].body));
  }
  std::vector<std::vector<std::size_t>> found;
  std::map<Index, std::size_t> places;  // of the sets' roots
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    const auto [place, is_new] = places.try_emplace(tied.root(static_cast<Index>(body)), found.size());
    if (is_new) {
      found.emplace_back();
    }
    found[place->second].push_back(body);
  }
  return found;
}

Scene assembly_of(Scene scene, std::size_t body) {
  const auto all = assemblies(scene);
  std::vector<std::size_t> parts =
      *std::ranges::find_if(all, [&](const auto& set) { return std::ranges::binary_search(set, body); });
  std::stable_partition(parts.begin(), parts.end(), [&](std::size_t part) { return part == body; });
  std::map<std::size_t, std::size_t> places;  // of the parts, among the parts
  std::vector<Body> bodies;
  for (const std::size_t part : parts) {
    places.emplace(part, bodies.size());
    bodies.push_back(scene.bodies[part]);
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
    throw deck::DeckError(joint.where, fmt::format("joints.{}: '{}' does not know joints; use 'run', 'modes', 'map' or "
                                                   "'radiate', or leave the joints out",
                                                   joint.name, work));
  }
}

}  // namespace idiophone::scene
