#include "idiophone/scene/joined_solids.hpp"

#include <algorithm>
#include <map>

#include "idiophone/foundation/disjoint_sets.hpp"
#include "idiophone/scene/large_amplitudes.hpp"

namespace idiophone::scene {

std::vector<std::vector<std::size_t>> assemblies(const Solids& solids) {
  DisjointSets tied(solids.bodies.size());
  for (const Joint& joint : solids.joints) {
    tied.join(static_cast<Index>(joint.surfaces[0].body), static_cast<Index>(joint.surfaces[1].body));
  }
  std::vector<std::vector<std::size_t>> found;
  std::map<Index, std::size_t> places;  // of the sets' roots
  for (std::size_t body = 0; body < solids.bodies.size(); ++body) {
    const auto [place, is_new] = places.try_emplace(tied.root(static_cast<Index>(body)), found.size());
    if (is_new) {
      found.emplace_back();
    }
    found[place->second].push_back(body);
  }
  return found;
}

bool has_common_modes(const Solids& solids, std::size_t body) {
  return has_large_amplitudes(solids.bodies[body]) && std::ranges::any_of(solids.joints, [&](const Joint& joint) {
           return joint.surfaces[0].body == body || joint.surfaces[1].body == body;
         });
}

Assembly::Assembly(const Solids& all, std::size_t body) : rest(all.alone(body)) {
  const auto sets = assemblies(all);
  std::vector<std::size_t> parts =
      *std::ranges::find_if(sets, [&](const auto& set) { return std::ranges::binary_search(set, body); });
  std::stable_partition(parts.begin(), parts.end(), [&](std::size_t part) { return part == body; });
  std::map<std::size_t, std::size_t> places;  // of the parts, among the parts
  for (const std::size_t part : parts) {
    places.emplace(part, bodies.size());
    bodies.push_back(all.bodies[part]);
  }
  for (Joint joint : all.joints) {
    if (places.contains(joint.surfaces[0].body)) {
      for (JoinedSurface& surface : joint.surfaces) {
        surface.body = places.at(surface.body);
      }
      joints.push_back(std::move(joint));
    }
  }
}

Solids Assembly::solids() const {
  Solids result = rest;
  result.bodies = bodies;
  result.joints = joints;
  return result;
}

}  // namespace idiophone::scene
