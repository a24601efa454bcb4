#include "ranges.hpp"
#include "sections.hpp"

namespace idiophone::scene {

namespace {

enum class LoadType { pulse, pluck };

/// The keys that both types have: body, at, radius, force.
template <class Load>
void read_force(Section& section, Load& load, const std::vector<Body>& bodies) {
  load.name = section.node().key;
  if (bodies.size() > 1) {
    section.required("body", load.body, names_of(bodies));
  } else {
    section.optional("body", load.body, names_of(bodies));
  }
  read_place(section, load.place);
  if (section.required("force", load.force, force_component) && load.force.isZero(0.0)) {
    section.mistakes().add(*section.find("force"), "is zero; a load needs a force (N)");
  }
}

void read_load(const Node& node, Mistakes& mistakes, Scene& scene) {
  const Choices<LoadType> types{{{"pulse", LoadType::pulse}, {"pluck", LoadType::pluck}}};
  Section section(node, mistakes);
  LoadType type = LoadType::pulse;
  if (!section.optional("type", type, types)) {
    return;  // the other keys depend on it
  }
  if (type == LoadType::pluck) {
    read_force(section, scene.plucks.emplace_back(), scene.bodies);
  } else {
    ForcePulse& pulse = scene.pulses.emplace_back();
    read_force(section, pulse, scene.bodies);
    read_signal(section, {scene.deck.parent_path()}, pulse.signal);
  }
  section.finish();
}

}  // namespace

bool read_loads(const Node& node, Mistakes& mistakes, Scene& scene) {
  if (node.kind != Node::Kind::map) {
    return mistakes.add(node, "expected a map of names, found " + describe(node));
  }
  const std::size_t before = mistakes.count();
  for (const Node& load : node.children) {
    check_name(load.key, load.key_where, mistakes);
    read_load(load, mistakes, scene);
  }
  return mistakes.count() == before;
}

}  // namespace idiophone::scene
