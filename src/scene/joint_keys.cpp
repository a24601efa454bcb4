#include "joint_keys.hpp"

#include "idiophone/scene/ranges.hpp"

namespace idiophone::scene {

namespace {

constexpr Range layer_stiffness{.above = 0.0, .at_most = 1e18, .unit = "Pa/m"};
constexpr Range spring_stiffness{.above = 0.0, .at_most = 1e15, .unit = "N/m"};

}  // namespace

/// {normal, tangential} of a layer
static bool read(const Node& node, Mistakes& mistakes, JointStiffness& stiffness) {
  Section section(node, mistakes);
  section.required("normal", stiffness.normal, layer_stiffness);
  section.required("tangential", stiffness.tangential, layer_stiffness);
  return section.finish();
}

bool read_layer_stiffness(Section& section, std::optional<JointStiffness>& stiffness) {
  const Node* node = section.find("stiffness");
  if (node == nullptr || (node->kind == Node::Kind::scalar && node->text == "rigid")) {
    return true;
  }
  if (node->kind != Node::Kind::map) {
    return section.mistakes().add(*node, "expected rigid or {normal, tangential}, found " + describe(*node));
  }
  return read(*node, section.mistakes(), stiffness.emplace());
}

const Material* read_joint_material(Section& section, Joint& joint, const std::vector<Material>& materials) {
  std::size_t index = 0;
  if (!section.required("material", index, names_of(materials))) {
    return nullptr;
  }
  const Material& material = materials[index];
  if (!material.is_isotropic()) {
    section.mistakes().add(
        *section.find("material"),
        fmt::format("'{}' is not isotropic, as that of a joint must be: name another material", material.name));
  }
  if (material.damping.loss && section.find("damping") == nullptr) {
    section.mistakes().add(
        *section.find("material"),
        fmt::format("'{}' has a loss factor, which joints do not have: give the joint a damping (s)", material.name));
  }
  joint.damping = material.damping.stiffness;
  return &material;
}

namespace {

/// N/m along and across a spring.
void read_two_directions(const Node& node, Mistakes& mistakes, JointStiffness& stiffness) {
  constexpr Range one_way{.at_least = 0.0, .at_most = spring_stiffness.at_most, .unit = spring_stiffness.unit};
  Section section(node, mistakes);
  const bool axial = section.required("axial", stiffness.normal, one_way);
  if (section.required("lateral", stiffness.tangential, one_way) && axial && stiffness.normal == 0.0 &&
      stiffness.tangential == 0.0) {
    mistakes.add(node, "axial and lateral are both zero: a spring needs a stiffness (N/m)");
  }
  section.finish();
}

}  // namespace

void read_spring(Section& section, Joint& joint) {
  JointStiffness& stiffness = joint.stiffness.emplace();
  if (const Node* node = section.find("stiffness"); node != nullptr && node->kind == Node::Kind::map) {
    read_two_directions(*node, section.mistakes(), stiffness);
  } else if (section.required("stiffness", stiffness.normal, spring_stiffness)) {
    stiffness.tangential = stiffness.normal;
  }
  if (section.find("at") != nullptr) {
    read_place(section, joint.place.emplace());
  } else {
    section.refuse("radius", "has no meaning without at: a spring without a place holds the whole surfaces");
  }
}

bool read(const Node& node, Mistakes& mistakes, JointAxis& axis) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected a list of 2 points, [[x, y, z], [x, y, z]], found " + describe(node));
  }
  const bool first = read(node.children[0], mistakes, axis.begin, coordinate);
  if (!read(node.children[1], mistakes, axis.end, coordinate) || !first) {
    return false;
  }
  return axis.begin != axis.end || mistakes.add(node, "its two points are the same, so there is no line between them");
}

static bool read(const Node& node, Mistakes& mistakes, HingeTurning& turning) {
  Section section(node, mistakes);
  section.required("stiffness", turning.stiffness, Range{.above = 0.0, .at_most = 1e12, .unit = "N m/rad"});
  section.optional("damping", turning.damping, joint_damping);
  return section.finish();
}

void read_hinge(Section& section, Joint& joint) {
  section.required("axis", joint.axis);
  const Node* given = section.find("stiffness");
  if (given != nullptr && !(given->kind == Node::Kind::scalar && given->text == "rigid")) {
    JointStiffness& stiffness = joint.stiffness.emplace();
    section.required("stiffness", stiffness.normal, spring_stiffness);
    stiffness.tangential = stiffness.normal;
  }
  if (const Node* turning = section.find("turning")) {
    read(*turning, section.mistakes(), joint.turning.emplace());
  }
}

}  // namespace idiophone::scene
