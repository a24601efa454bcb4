#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

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

void read_pluck(Section& section, Scene& scene) {
  Pluck& pluck = scene.plucks.emplace_back();
  read_force(section, pluck, scene.bodies);
  if (pluck.body >= scene.bodies.size()) {
    return;
  }
  const Material& material = scene.materials[scene.bodies[pluck.body].material];
  if (material.damping.of_vibration() > 0) {
    section.mistakes().add(
        section.node(),
        fmt::format("a pluck holds the body at rest under a force, under which its material would creep: "
                    "materials.{}.damping has mass_of: vibration. Take mass_of: all",
                    material.name));
  }
}

/// Only a body that can move freely moves as a whole under a load.
void refuse_balance_if_held(Section& section, const Body& body) {
  if (!body.fixed.empty() || !body.driven.empty()) {
    section.refuse("balanced",
                   fmt::format("has no meaning here: body '{}' is held and does not move as a whole", body.name));
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
    read_pluck(section, scene);
  } else {
    ForcePulse& pulse = scene.pulses.emplace_back();
    read_force(section, pulse, scene.bodies);
    read_signal(section, {scene.deck.parent_path()}, pulse.signal);
    section.optional("balanced", pulse.is_balanced, Choices<bool>{{{"true", true}, {"false", false}}});
    if (pulse.is_balanced && pulse.body < scene.bodies.size()) {
      refuse_balance_if_held(section, scene.bodies[pulse.body]);
    }
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
