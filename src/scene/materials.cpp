#include <algorithm>

#include "idiophone/scene/sections.hpp"
#include "shipped_materials.hpp"

namespace idiophone::scene {

bool read(const Node& node, Mistakes& mistakes, std::array<double, 2>& range, const FrequencyBand& /*rule*/) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected a list of 2 numbers (Hz), e.g. [20, 20000], found " + describe(node));
  }
  const Range hearable{.at_least = 1e-3, .at_most = 1e6, .unit = "Hz"};
  std::array<double, 2> found{};
  if (!read(node.children[0], mistakes, found[0], hearable) || !read(node.children[1], mistakes, found[1], hearable)) {
    return false;
  }
  if (found[0] >= found[1]) {
    return mistakes.add(node,
                        fmt::format("must ascend, found {} and {}", node.children[0].text, node.children[1].text));
  }
  range = found;
  return true;
}

Node to_node(const std::array<double, 2>& range, const FrequencyBand& /*rule*/) {
  Node list;
  list.kind = Node::Kind::list;
  for (const double frequency : range) {
    list.children.push_back(to_node(frequency, Range{}));
  }
  return list;
}

namespace {

/// @param table  of the shipped material that this one starts from
void read_loss(Section& section, Damping& damping, const std::optional<LossFactor>& table) {
  const Node* value = section.find("loss_factor");
  LossFactor loss;
  if (value == nullptr) {
    section.refuse("band", "has no meaning without a loss_factor");
    section.refuse("mechanisms", "has no meaning without a loss_factor");
  } else {
    loss.where = value->where;
  }
  if (value == nullptr || value->text != "table") {
    section.optional("loss_factor", loss.value, Range{.at_least = 0.0, .at_most = 0.3});
  } else if (table) {
    loss.value = table->value;
  } else {
    section.refuse("loss_factor", "can't be 'table' without a shipped material; name one with the key from");
  }
  section.optional("band", loss.band, frequency_band);
  section.optional("mechanisms", loss.mechanisms, Range{.at_least = 1, .at_most = 12});
  if (loss.value > 0) {
    damping.loss = loss;
  }
}

}  // namespace

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
  read_elastic_constants(section, material);
  const Range solid_density{.at_least = 1e-3, .at_most = 1e6, .unit = "kg/m3"};
  if (section.find("from") == nullptr) {
    section.required("density", material.density, solid_density);
  } else {
    section.optional("density", material.density, solid_density);
  }
  section.optional("damping", material.damping);
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
