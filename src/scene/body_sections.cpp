#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/scene/euler_angles.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, Support& support) {
  Section section(node, mistakes);
  read_place(section, support.place);
  section.optional("stiffness", support.stiffness, Range{.at_least = 0.0, .at_most = 1e15, .unit = "N/m"});
  section.optional("damping", support.damping, Range{.at_least = 0.0, .at_most = 1e12, .unit = "N s/m"});
  const bool good = section.finish();
  if (good && support.stiffness == 0.0 && support.damping == 0.0) {
    return mistakes.add(node, "a support needs a stiffness (N/m) or a damping (N s/m) above 0");
  }
  return good;
}

bool read(const Node& node, Mistakes& mistakes, Eigen::Matrix3d& axes, const Grain& /*rule*/) {
  Section section(node, mistakes);
  if (section.find("euler") != nullptr) {
    section.refuse("x", "has no meaning beside euler");
    section.refuse("y", "has no meaning beside euler");
    Vector3 degrees;
    section.required("euler", degrees, Range{.at_least = -360.0, .at_most = 360.0, .unit = "degrees"});
    if (!section.finish()) {
      return false;
    }
    axes = axes_of_euler_angles(degrees);
    return true;
  }
  Vector3 x = Vector3::UnitX();
  Vector3 y = Vector3::UnitY();
  section.required("x", x, unit_vector);
  section.required("y", y, unit_vector);
  if (!section.finish()) {
    return false;
  }
  if (std::abs(x.dot(y)) > 1e-6) {
    return mistakes.add(node, fmt::format("x and y must be at right angles, found {:.6g} degrees",
                                          std::acos(x.dot(y)) * 180 / std::numbers::pi));
  }
  axes << x, y, x.cross(y);
  return true;
}

Node to_node(const Eigen::Matrix3d& axes, const Grain& /*rule*/) {
  Node node;
  node.kind = Node::Kind::map;
  for (const int axis : {0, 1}) {
    node.children.push_back(to_node(Vector3(axes.col(axis)), unit_vector));
    node.children.back().key = "xyz"[axis];
  }
  return node;
}

/// Orders of hexahedra along the plane and the thickness of a thin body.
struct HexOrder {
  int plane;
  int thickness;
};

/// order: {plane, thickness}
static bool read(const Node& node, Mistakes& mistakes, HexOrder& order) {
  const Range orders{.at_least = element::lowest_hex_order, .at_most = element::highest_hex_order};
  Section section(node, mistakes);
  section.optional("plane", order.plane, orders);
  section.optional("thickness", order.thickness, orders);
  return section.finish();
}

/// mass_scaling: {shift}
static bool read(const Node& node, Mistakes& mistakes, MassScalingLimit& scaling) {
  Section section(node, mistakes);
  section.required("shift", scaling.shift, Range{.above = 0.0, .at_most = 100.0, .unit = "cents"});
  return section.finish();
}

namespace {

/// What only elements with a choice of orders have.
void read_hexahedra(Section& section, Body& body) {
  if (element::has_choice_of_orders(body.element)) {
    HexOrder order{body.element.plane, body.element.thickness};
    section.optional("order", order);
    body.element = element::with_orders(body.element, {order.plane, order.thickness});
    section.optional("mass_scaling", body.mass_scaling);
    section.optional("thickness", body.thickness, wall_thickness);
    if (body.thickness) {
      body.thickness_where = section.find("thickness")->where;
    }
  } else {
    for (const char* key : {"order", "mass_scaling", "thickness"}) {
      if (section.find(key) != nullptr) {
        section.refuse(key,
                       fmt::format("has no meaning with element {}: only hex has it", element::name(body.element)));
      }
    }
  }
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Body& body, const Scene& so_far) {
  Choices<element::Type> elements;
  for (const element::Type type : element::types()) {
    elements.words.emplace_back(element::name(type), type);
  }
  const Folder folder{so_far.deck.parent_path()};
  body.where = node.key_where;
  Section section(node, mistakes);
  read_mesh(section, body, folder);
  section.optional("rotation", body.rotation, turn);
  section.optional("position", body.position, coordinate);
  section.optional("element", body.element, elements);
  read_hexahedra(section, body);
  read_materials(section, body, so_far.materials);
  read_constraints(section, body, folder);
  section.optional("supports", body.supports);
  read_model(section, body);
  read_fracture(section, body);
  read_prestress(section, body, so_far.materials);
  section.optional("springs", body.springs, folder);
  section.optional("velocity", body.velocity, Range{.at_least = -1e5, .at_most = 1e5, .unit = "m/s"});
  section.optional("spin", body.spin, Range{.at_least = -1e6, .at_most = 1e6, .unit = "rad/s"});
  return section.finish();
}

/// bodies.NAME: {recording}
static bool read(const Node& node, Mistakes& mistakes, RecordedBody& body, const Folder& folder) {
  Section section(node, mistakes);
  if (section.required("recording", body.recording, folder)) {
    body.where = section.find("recording")->where;
  }
  return section.finish();
}

namespace {

bool is_recorded(const Node& body) {
  return std::ranges::find(body.children, "recording", &Node::key) != body.children.end();
}

}  // namespace

bool read_bodies(Section& deck, Scene& scene) {
  const Node* bodies = deck.find("bodies");
  if (bodies == nullptr || bodies->kind != Node::Kind::map) {
    return deck.required("bodies", scene.bodies, scene);
  }
  if (std::ranges::all_of(bodies->children, is_recorded)) {
    return deck.mistakes().add(*bodies, bodies->children.empty()
                                            ? "is empty; it needs at least one entry"
                                            : "has recorded bodies only; use 'idiophone listen' for their sound");
  }
  bool good = true;
  for (const Node& body : bodies->children) {
    good &= is_recorded(body)
                ? deck::read_entry(body, deck.mistakes(), scene.recorded_bodies, Folder{scene.deck.parent_path()})
                : deck::read_entry(body, deck.mistakes(), scene.bodies, scene);
  }
  return good;
}

}  // namespace idiophone::scene
