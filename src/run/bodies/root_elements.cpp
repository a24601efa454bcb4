#include "root_elements.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/scene/joined_solids.hpp"

namespace idiophone::bodies {

namespace {

void add(std::span<const Index> more, std::vector<Index>& nodes) {
  nodes.insert(nodes.end(), more.begin(), more.end());
}

bool is_deformed_at_rest(const scene::Scene& scene, std::size_t body) {
  return scene.bodies[body].prestress ||
         std::ranges::find(scene.plucks, body, &scene::Pluck::body) != scene.plucks.end();
}

}  // namespace

std::vector<std::vector<Index>> nodes_of_root_elements(const scene::Scene& scene,
                                                       const std::vector<mesh::Mesh>& outlines) {
  std::vector<std::vector<Index>> nodes(outlines.size());
  for (std::size_t body = 0; body < nodes.size(); ++body) {
    if (std::ranges::any_of(scene.contacts, [&](const auto& c) { return c.body == body || c.other == body; })) {
      std::ranges::for_each(outlines[body].surface, [&](const mesh::Triangle& one) { add(one, nodes[body]); });
    }
  }
  for (const scene::Joint& joint : scene.joints) {
    for (const scene::JoinedSurface& surface : joint.surfaces) {
      add(mesh::find_group(outlines[surface.body], surface.group, surface.where), nodes[surface.body]);
    }
  }
  for (const std::vector<std::size_t>& assembly : scene::assemblies(scene)) {
    if (std::ranges::any_of(assembly, [&](std::size_t body) { return is_deformed_at_rest(scene, body); })) {
      for (const std::size_t body : assembly) {
        nodes[body].resize(outlines[body].nodes.size());
        std::iota(nodes[body].begin(), nodes[body].end(), 0);
      }
    }
  }
  std::ranges::for_each(nodes, keep_each_once<Index>);
  return nodes;
}

}  // namespace idiophone::bodies
