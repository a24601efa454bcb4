#include <algorithm>
#include <cmath>

#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/instruments/sound_maps/ideal_deck.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/scene_file.hpp"
#include "outline_checks.hpp"

namespace idiophone::sound_maps {

using namespace deck;  // values, keys and sections

/// The rule for a corner: a list of two coordinates, m.
struct PlanePoint {};

namespace {

constexpr PlanePoint plane_point;

using Type = IdealBody::Type;

constexpr deck::Range positive_metres{.above = 0.0, .at_most = 1e3, .unit = "m"};

/// Whether the type has a key.
bool type_has(Type type, std::string_view key) {
  using Keys = std::vector<std::string_view>;
  switch (type) {
    case Type::membrane:
      return std::ranges::count(Keys{"polygon", "radius", "size", "tension"}, key) > 0;
    case Type::string:
      return std::ranges::count(Keys{"length", "width", "tension"}, key) > 0;
    case Type::bar:
      return std::ranges::count(Keys{"length", "width", "ends", "tension", "stiffness"}, key) > 0;
    case Type::plate:
      return std::ranges::count(Keys{"length", "width", "tension", "stiffness"}, key) > 0;
  }
  return false;
}

/// Refuses the keys that belong to other types.
void refuse_others(Section& section, Type type) {
  for (const char* key : {"polygon", "radius", "size", "length", "width", "ends", "tension", "stiffness"}) {
    if (!type_has(type, key)) {
      section.refuse(key, "has no meaning for this type of ideal body");
    }
  }
}

void read_outline(Section& section, IdealBody& body) {
  const bool is_read = section.optional("polygon", body.polygon, plane_point);
  section.optional("size", body.size, positive_metres);
  if (const Node* polygon = section.find("polygon")) {
    section.refuse("radius", "belongs to a disc, which has no polygon");
    if (polygon->kind == Node::Kind::list && body.polygon.size() < 3) {
      section.mistakes().add(*polygon, "needs at least 3 corners");
    } else if (is_read) {
      check_polygon(*polygon, body.polygon, section.mistakes());
    }
  } else {
    section.required("radius", body.radius, positive_metres);
  }
}

/// Elements as long as a thirtieth of the outline unless the deck gives their size.
double default_size(const IdealBody& body) {
  double farthest = body.radius;
  for (const auto& corner : body.polygon) {
    for (const auto& other : body.polygon) {
      farthest = std::max(farthest, 0.5 * std::hypot(corner[0] - other[0], corner[1] - other[1]));
    }
  }
  return farthest / 15.0;
}

}  // namespace

static bool read(const Node& node, Mistakes& mistakes, std::array<double, 2>& point, const PlanePoint& /*rule*/) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, fmt::format("expected two coordinates, [x, y], found {}", describe(node)));
  }
  const bool first = read(node.children[0], mistakes, point[0], scene::coordinate);
  return read(node.children[1], mistakes, point[1], scene::coordinate) && first;
}

static bool read(const Node& node, Mistakes& mistakes, IdealBody& body) {
  const Choices<Type> types{
      {{"membrane", Type::membrane}, {"string", Type::string}, {"bar", Type::bar}, {"plate", Type::plate}}};
  const Choices<IdealBody::Ends> ends{{{"supported", IdealBody::Ends::supported},
                                       {"free", IdealBody::Ends::free},
                                       {"clamped", IdealBody::Ends::clamped},
                                       {"clamped_free", IdealBody::Ends::clamped_free}}};
  const deck::Range tension{.above = 0.0, .at_most = 1e9, .unit = "N or N/m"};
  const deck::Range stiffness{.above = 0.0, .at_most = 1e12, .unit = "N m2 or N m"};
  body.where = node.key_where;
  Section section(node, mistakes);
  const bool has_type = section.required("type", body.type, types);
  if (has_type) {
    refuse_others(section, body.type);
  }
  if (body.type == Type::membrane) {
    read_outline(section, body);
    body.size = body.size > 0.0 ? body.size : default_size(body);
  } else {
    section.required("length", body.length, positive_metres);
    section.required("width", body.width, positive_metres);
  }
  if (body.type == Type::membrane || body.type == Type::string) {
    section.required("tension", body.tension, tension);
  } else {
    section.optional("tension", body.tension, deck::Range{.at_least = 0.0, .at_most = 1e9, .unit = "N or N/m"});
    section.required("stiffness", body.stiffness, stiffness);
  }
  if (body.type == Type::bar) {
    section.optional("ends", body.ends, ends);
    if (body.tension > 0.0 && body.ends != IdealBody::Ends::supported) {
      section.refuse("tension", "needs supported ends");
    }
  }
  section.required("density", body.density, deck::Range{.above = 0.0, .at_most = 1e6, .unit = "kg/m or kg/m2"});
  section.optional("friction", body.friction, deck::Range{.at_least = 0.0, .at_most = 1.0});
  section.optional("position", body.position, scene::coordinate);
  return section.finish();
}

namespace {

/// Reports listeners that hear nothing of a body, because they are in its wall or behind it.
void check_listeners(const IdealDeck& deck, Mistakes& mistakes) {
  for (const scene::Listener& listener : deck.scene.listeners) {
    for (const IdealBody& body : deck.bodies) {
      const double wall = body.position[2];
      const auto is_behind = [&](const scene::Receiver& receiver) {
        return listener.place(receiver, 0.0).position[2] <= wall;
      };
      if (std::ranges::any_of(listener.receivers, is_behind)) {
        mistakes.add(
            listener.where,
            fmt::format("listeners.{}: hears nothing of body '{}', which sounds in front of its wall only: the "
                        "z of its position must be above {:.6g} m",
                        listener.name, body.name, wall));
        break;
      }
    }
  }
}

/// A deck that has been read, and its tree with what its readers noted.
struct ReadIdealDeck {
  IdealDeck deck;
  Node tree;
};

ReadIdealDeck read_ideal_deck_with_tree(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  IdealDeck deck;
  scene::Scene& scene = deck.scene;
  Node tree = scene::read_scene_file(file, overrides, scene, [&](Section& section) {
    scene::require_some(section, "ideal_bodies", deck.bodies);
    scene::require_some(section, "listeners", scene.listeners, Folder{file.parent_path()});
    section.optional("radiation", scene.radiation, scene.audio);
    scene::refuse_attached(scene.listeners, section.mistakes());
    if (section.mistakes().count() == 0) {  // else places may be missing
      check_listeners(deck, section.mistakes());
    }
  });
  return {std::move(deck), std::move(tree)};
}

}  // namespace

bool has_ideal_bodies(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  Mistakes mistakes;
  const Node tree = read_tree(deck::read_text(deck), deck.string(), overrides, mistakes);
  mistakes.raise();
  return std::ranges::find(tree.children, "ideal_bodies", &Node::key) != tree.children.end();
}

IdealDeck read_ideal_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return read_ideal_deck_with_tree(deck, overrides).deck;
}

std::string resolved_ideal_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return deck::resolved(read_ideal_deck_with_tree(deck, overrides).tree);
}

}  // namespace idiophone::sound_maps
