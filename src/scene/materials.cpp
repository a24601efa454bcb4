#include <algorithm>

#include "idiophone/scene/shipped_materials.hpp"
#include "sections.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, Damping& damping) {
  Section section(node, mistakes);
  section.optional("mass", damping.mass, Range{.at_least = 0.0, .at_most = 1e9, .unit = "1/s"});
  section.optional("stiffness", damping.stiffness, Range{.at_least = 0.0, .at_most = 1e3, .unit = "s"});
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, Material& material) {
  Section section(node, mistakes);
  std::optional<std::size_t> shipped;
  section.optional("from", shipped, names_of(shipped_materials()));
  if (shipped) {
    const std::string name = material.name;
    material = shipped_materials()[*shipped];
    material.name = name;
  }
  material.where = node.key_where;
  // What it starts from has all that must be given otherwise.
  const auto need = [&](const std::string& key, auto& value, const auto& rule) {
    return section.find("from") != nullptr ? section.optional(key, value, rule) : section.required(key, value, rule);
  };
  need("young", material.young, Range{.above = 0.0, .at_most = 1e15, .unit = "Pa"});
  need("poisson", material.poisson, Range{.above = -1.0, .below = 0.5});
  need("density", material.density, Range{.above = 0.0, .at_most = 1e6, .unit = "kg/m3"});
  section.optional("damping", material.damping);
  return section.finish();
}

void add_shipped(std::vector<Material>& materials) {
  for (const Material& shipped : shipped_materials()) {
    if (std::ranges::find(materials, shipped.name, &Material::name) == materials.end()) {
      materials.push_back(shipped);
    }
  }
}

}  // namespace idiophone::scene
