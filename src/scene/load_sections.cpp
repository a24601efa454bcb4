#include "idiophone/scene/bow_keys.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, Gusts& gusts) {
  Section section(node, mistakes);
  int seed = static_cast<int>(gusts.seed);
  section.optional("intensity", gusts.intensity, Range{.at_least = 0.0, .at_most = 10.0});
  section.optional("time", gusts.time, Range{.at_least = 1e-4, .at_most = 1e6, .unit = "s"});
  section.optional("seed", seed, Range{.at_least = 0.0, .at_most = 2e9});
  gusts.seed = static_cast<std::uint64_t>(seed);
  return section.finish();
}

namespace {

enum class LoadType { pulse, pluck, wind, bow };

/// The keys that all loads on a patch have: body, at, radius.
template <class Load>
void read_patch(Section& section, Load& load, const std::vector<Body>& bodies) {
  load.name = section.node().key;
  if (bodies.size() > 1) {
    section.required("body", load.body, names_of(bodies));
  } else {
    section.optional("body", load.body, names_of(bodies));
  }
  read_place(section, load.place);
}

/// The keys that pulses and plucks have: those of a patch, and force.
template <class Load>
void read_force(Section& section, Load& load, const std::vector<Body>& bodies) {
  read_patch(section, load, bodies);
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
  const Body& body = scene.bodies[pluck.body];
  if (!body.fracture.empty()) {
    section.mistakes().add(section.node(), fmt::format("a pluck cannot act on body '{}', which has `fracture`: take a "
                                                       "pulse, or leave fracture out",
                                                       body.name));
  }
  for (const MaterialRegion& region : body.all_regions()) {
    const Material& material = scene.materials[region.material];
    if (material.damping.of_vibration() > 0) {
      section.mistakes().add(
          section.node(),
          fmt::format("a pluck holds the body at rest under a force, under which its material would creep: "
                      "materials.{}.damping has mass_of: vibration. Take mass_of: all",
                      material.name));
    }
  }
}

/// Only a body that can move freely moves as a whole under a load.
void refuse_balance_if_held(Section& section, const Body& body) {
  if (!body.fixed.empty() || !body.driven.empty()) {
    section.refuse("balanced",
                   fmt::format("has no meaning here: body '{}' is held and does not move as a whole", body.name));
  }
}

void read_pulse(Section& section, Scene& scene) {
  ForcePulse& pulse = scene.pulses.emplace_back();
  read_force(section, pulse, scene.bodies);
  read_signal(section, {scene.deck.parent_path()}, pulse.signal);
  section.optional("balanced", pulse.is_balanced, Choices<bool>{{{"true", true}, {"false", false}}});
  if (pulse.is_balanced && pulse.body < scene.bodies.size()) {
    refuse_balance_if_held(section, scene.bodies[pulse.body]);
  }
}

void read_wind(Section& section, Scene& scene) {
  Wind& wind = scene.winds.emplace_back();
  wind.name = section.node().key;
  section.optional("body", wind.body, names_of(scene.bodies));
  if (section.required("velocity", wind.velocity, Range{.at_least = -1e3, .at_most = 1e3, .unit = "m/s"}) &&
      wind.velocity.isZero(0.0)) {
    section.mistakes().add(*section.find("velocity"), "is zero; a wind needs a velocity (m/s)");
  }
  section.optional("drag", wind.drag, Range{.above = 0.0, .at_most = 100.0});
  section.optional("gusts", wind.gusts);
  wind.signal.shape = Signal::Shape::constant;
  read_signal(section, {scene.deck.parent_path()}, wind.signal);
}

void read_bow(Section& section, Scene& scene) {
  Bow& bow = scene.bows.emplace_back();
  read_patch(section, bow, scene.bodies);
  const std::size_t before = section.mistakes().count();
  read_bowing(section, bow, positive_seconds.at_most);
  if (section.mistakes().count() == before && bow.load.largest() == 0.0) {
    section.mistakes().add(*section.find("load"), "is zero; a bow needs a load that presses it on (N)");
  }
  section.optional("start", bow.start, Range{.at_least = 0.0, .at_most = positive_seconds.at_most, .unit = "s"});
  bow.duration = infinity;
  section.optional("duration", bow.duration, positive_seconds);
}

void read_load(const Node& node, Mistakes& mistakes, Scene& scene) {
  const Choices<LoadType> types{
      {{"pulse", LoadType::pulse}, {"pluck", LoadType::pluck}, {"wind", LoadType::wind}, {"bow", LoadType::bow}}};
  Section section(node, mistakes);
  LoadType type = LoadType::pulse;
  if (!section.optional("type", type, types)) {
    return;  // the other keys depend on it
  }
  switch (type) {
    case LoadType::pulse:
      read_pulse(section, scene);
      break;
    case LoadType::pluck:
      read_pluck(section, scene);
      break;
    case LoadType::wind:
      read_wind(section, scene);
      break;
    case LoadType::bow:
      read_bow(section, scene);
      break;
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
