#include <fmt/format.h>

#include <algorithm>

#include "idiophone/scene/sections.hpp"
#include "loss_section.hpp"
#include "shipped_materials.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, Damping& damping) {
  Section section(node, mistakes);
  const std::optional<LossFactor> table = damping.loss;
  damping = {};
  section.optional("mass", damping.mass, Range{.at_least = 0.0, .at_most = 1e9, .unit = "1/s"});
  section.optional("mass_of", damping.mass_of,
                   Choices<DampedMotion>{{{"all", DampedMotion::all}, {"vibration", DampedMotion::vibration}}});
  section.optional("stiffness", damping.stiffness, Range{.at_least = 0.0, .at_most = 0.01, .unit = "s"});
  read_loss(section, damping, table);
  return section.finish();
}

/// Loss factors by direction belong to moduli by direction, and act on the vibration by themselves.
static void check_directions(Section& section, const Material& material) {
  const Damping& damping = material.damping;
  if (!damping.has_directional_loss()) {
    return;
  }
  const Node& node = *section.find("damping");
  if (!material.orthotropy) {
    section.mistakes().add(node,
                           "loss_factor by direction needs a material with young, poisson and shear by direction");
  }
  if (damping.of_vibration() > 0) {
    section.mistakes().add(node, "mass_of: vibration can't be combined with a loss_factor by direction");
  }
}

/// Whether an entry changes nothing but losses or expansion of a material that comes with the program.
static bool lacks_from(const Node& node, const std::string& name) {
  const auto changes = [](const Node& child) { return child.key == "damping" || child.key == "expansion"; };
  return node.kind == Node::Kind::map && !node.children.empty() && std::ranges::all_of(node.children, changes) &&
         std::ranges::find(shipped_materials(), name, &Material::name) != shipped_materials().end();
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
  if (lacks_from(node, material.name)) {
    return mistakes.add(node,
                        fmt::format("no constants; 'from: {}' takes those of the shipped material", material.name));
  }
  read_elastic_constants(section, material);
  const Range solid_density{.at_least = 1e-3, .at_most = 1e6, .unit = "kg/m3"};
  if (section.find("from") == nullptr) {
    section.required("density", material.density, solid_density);
  } else {
    section.optional("density", material.density, solid_density);
  }
  section.optional("damping", material.damping);
  check_directions(section, material);
  section.optional("expansion", material.expansion, Range{.at_least = -1e-3, .at_most = 1e-3, .unit = "1/K"});
  return section.finish();
}

void add_shipped(std::vector<Material>& materials) {
  for (const Material& shipped : shipped_materials()) {
    if (std::ranges::find(materials, shipped.name, &Material::name) == materials.end()) {
      materials.push_back(shipped);
      materials.back().damping = {};
    }
  }
}

}  // namespace idiophone::scene
