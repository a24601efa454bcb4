#include <algorithm>

#include "friction_keys.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

/// What contacts may name: bodies and, numbered behind them, obstacles.
struct Touchable {
  Choices<std::size_t> names;
  std::size_t bodies;  ///< how many there are
};

Touchable touchable(const Scene& scene) {
  Touchable things{names_of(scene.bodies), scene.bodies.size()};
  for (const auto& [name, index] : names_of(scene.obstacles).words) {
    things.names.words.emplace_back(name, scene.bodies.size() + index);
  }
  return things;
}

}  // namespace

/// [BODY, BODY], [BODY, OBSTACLE] or [OBSTACLE, BODY]; one body twice touches itself
static bool read(const Node& node, Mistakes& mistakes, Contact& contact, const Touchable& things) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected a list of 2 names, [BODY, BODY] or [BODY, OBSTACLE], found " + describe(node));
  }
  std::size_t first = 0, second = 0;
  const bool first_known = read(node.children[0], mistakes, first, things.names);
  if (!read(node.children[1], mistakes, second, things.names) || !first_known) {
    return false;
  }
  if (first >= things.bodies && second >= things.bodies) {
    return mistakes.add(node, "names no body; one of the two must be a body");
  }
  contact.body = first < things.bodies ? first : second;
  const std::size_t partner = first < things.bodies ? second : first;
  if (partner < things.bodies) {
    contact.other = partner;
  } else {
    contact.obstacle = partner - things.bodies;
  }
  return true;
}

namespace {

/// The keys sticking and sliding.
void read_coulomb(Section& section, Friction& friction, const Range& coefficient) {
  const bool has_sticking = section.required("sticking", friction.sticking, coefficient);
  if (section.required("sliding", friction.sliding, coefficient) && has_sticking &&
      friction.sliding > friction.sticking) {
    section.mistakes().add(*section.find("sliding"), fmt::format("must be at most sticking, which is {}, found {}",
                                                                 friction.sticking, friction.sliding));
  }
}

}  // namespace

/// A number, {sticking, sliding} or {type: elasto_plastic, ...}
static bool read(const Node& node, Mistakes& mistakes, Friction& friction) {
  constexpr Range coefficient{.at_least = 0.0, .at_most = 100.0};
  if (node.kind != Node::Kind::map) {
    const bool good = read(node, mistakes, friction.sticking, coefficient);
    friction.sliding = friction.sticking;
    return good;
  }
  Section section(node, mistakes);
  bool has_memory = false;
  if (!section.optional("type", has_memory, Choices<bool>{{{"coulomb", false}, {"elasto_plastic", true}}})) {
    return false;  // the other keys depend on it
  }
  if (has_memory) {
    read_law(section, friction.memory.emplace());
  } else {
    read_coulomb(section, friction, coefficient);
  }
  return section.finish();
}

/// Without friction.
static Node to_node(const Friction& friction) {
  return to_node(friction.sticking, Range{});
}

static bool read(const Node& node, Mistakes& mistakes, Contact& contact, const Scene& so_far) {
  contact.where = node.key_where;
  Section section(node, mistakes);
  section.required("between", contact, touchable(so_far));
  section.optional("friction", contact.friction);
  section.optional("damping", contact.damping, Range{.at_least = 0.0, .at_most = 1e3, .unit = "s"});
  section.optional("stiffness", contact.stiffness, Range{.above = 0.0, .at_most = 1e24, .unit = "Pa/m"});
  return section.finish();
}

namespace {

/// Whether two contacts are between the same two things.
bool same_pair(const Contact& a, const Contact& b) {
  const bool same = a.body == b.body && a.other == b.other && a.obstacle == b.obstacle;
  return same || (a.other == b.body && b.other == a.body);
}

void refuse_second_contacts(const std::vector<Contact>& contacts, Mistakes& mistakes) {
  for (auto second = contacts.begin(); second != contacts.end(); ++second) {
    const auto first = std::find_if(contacts.begin(), second, [&](const Contact& c) { return same_pair(c, *second); });
    if (first != second) {
      mistakes.add(second->where, fmt::format("contacts.{}: '{}' at {} is between the same two already; leave one out",
                                              second->name, first->name, to_string(first->where)));
    }
  }
}

void refuse_idle_obstacles(const Scene& scene, Mistakes& mistakes) {
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    if (std::ranges::find(scene.contacts, std::optional(i), &Contact::obstacle) == scene.contacts.end()) {
      mistakes.add(scene.obstacles[i].where,
                   fmt::format("obstacles.{0}: no contact names it, so bodies pass through it; add 'contacts: "
                               "{{NAME: {{between: [BODY, {0}]}}}}', or leave it out",
                               scene.obstacles[i].name));
    }
  }
}

}  // namespace

bool read_contacts(Section& deck, Scene& scene) {
  if (!deck.optional("contacts", scene.contacts, scene)) {
    return false;
  }
  const std::size_t before = deck.mistakes().count();
  refuse_second_contacts(scene.contacts, deck.mistakes());
  refuse_idle_obstacles(scene, deck.mistakes());
  return deck.mistakes().count() == before;
}

}  // namespace idiophone::scene
