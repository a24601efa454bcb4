// Joints between bodies.

#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/scene/large_amplitudes.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"
#include "joint_keys.hpp"

namespace idiophone::scene {

namespace {

constexpr const char* kinds = "stiffness: {normal, tangential}, stiffness: rigid, or material and thickness";

}  // namespace

/// BODY.GROUP; the group may have points in its name.
static bool read(const Node& node, Mistakes& mistakes, JoinedSurface& surface, const Choices<std::size_t>& bodies) {
  surface.where = node.where;
  const std::size_t point = node.text.find('.');
  if (node.kind != Node::Kind::scalar || point == std::string::npos || point + 1 == node.text.size()) {
    return mistakes.add(node, "expected BODY.GROUP, a body and a physical group of its mesh, found " + describe(node));
  }
  surface.group = node.text.substr(point + 1);
  Node body = node;
  body.text = node.text.substr(0, point);
  return read(body, mistakes, surface.body, bodies);
}

/// [BODY.GROUP, BODY.GROUP]
static bool read(const Node& node, Mistakes& mistakes, std::array<JoinedSurface, 2>& surfaces,
                 const Choices<std::size_t>& bodies) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected a list of 2 surfaces, [BODY.GROUP, BODY.GROUP], found " + describe(node));
  }
  const bool first = read(node.children[0], mistakes, surfaces[0], bodies);
  if (!read(node.children[1], mistakes, surfaces[1], bodies) || !first) {
    return false;
  }
  if (surfaces[0].body == surfaces[1].body && surfaces[0].group == surfaces[1].group) {
    return mistakes.add(node, fmt::format("names '{}' twice; a joint is between two surfaces", node.children[0].text));
  }
  return true;
}

namespace {

/// A layer so thin that the bodies keep it from changing its width: E (1 - nu)/((1 + nu)(1 - 2 nu)) and G over its
/// thickness.
JointStiffness stiffness_of(const Material& material, double thickness) {
  const double nu = material.poisson;
  const double shear = material.young / (2 * (1 + nu));
  return {2 * shear * (1 - nu) / (1 - 2 * nu) / thickness, shear / thickness};
}

/// The keys material and thickness.
void read_layer_material(Section& section, Joint& joint, const std::vector<Material>& materials) {
  const Material* material = read_joint_material(section, joint, materials);
  double thickness = 0.0;
  if (section.required("thickness", thickness, Range{.above = 0.0, .at_most = 1.0, .unit = "m"}) &&
      material != nullptr) {
    joint.stiffness = stiffness_of(*material, thickness);
  }
}

void read_glue(Section& section, Joint& joint, const std::vector<Material>& materials) {
  const bool has_thickness = section.find("thickness") != nullptr;  // looked for in any case: then it is a known key
  const bool has_material = section.find("material") != nullptr || has_thickness;
  const bool has_stiffness = section.find("stiffness") != nullptr;
  if (has_material && has_stiffness) {
    section.refuse("stiffness", "cannot stand beside material and thickness: give one of them");
  } else if (has_material) {
    read_layer_material(section, joint, materials);
  } else if (has_stiffness) {
    read_layer_stiffness(section, joint.stiffness);
  } else {
    section.mistakes().add(section.node(), fmt::format("needs {}", kinds));
  }
  section.optional("reach", joint.reach, Range{.above = 0.0, .at_most = farthest_coordinate, .unit = "m"});
}

void read_type(Section& section, Joint& joint, const std::vector<Material>& materials) {
  switch (joint.type) {
    case JointType::glue:
      read_glue(section, joint, materials);
      break;
    case JointType::bolt:
      read_bolt(section, joint, materials);
      break;
    case JointType::spring:
      read_spring(section, joint);
      break;
    case JointType::hinge:
      read_hinge(section, joint);
      break;
  }
}

}  // namespace

static bool read(const Node& node, Mistakes& mistakes, Joint& joint, const Scene& so_far) {
  joint.where = node.key_where;
  const std::size_t before = mistakes.count();
  Section section(node, mistakes);
  const Choices<JointType> types{{{"glue", JointType::glue},
                                  {"bolt", JointType::bolt},
                                  {"spring", JointType::spring},
                                  {"hinge", JointType::hinge}}};
  if (!section.optional("type", joint.type, types)) {
    return false;  // the other keys depend on it
  }
  section.required("between", joint.surfaces, names_of(so_far.bodies));
  read_type(section, joint, so_far.materials);
  section.optional("damping", joint.damping, joint_damping);
  return section.finish() && mistakes.count() == before;
}

namespace {

/// What a body cannot have beside a joint; empty: nothing.
/// @param stretches  whether a body that joints tie to it has large amplitudes
std::string obstacle_to_joint(const Body& body, bool stretches) {
  if (!body.fracture.empty()) {
    return "can break: leave out its fracture or the joint";
  }
  if (stretches && !has_large_amplitudes(body)) {
    return "has no large_amplitudes, but a body that joints tie to it has: give model: {type: modal, large_amplitudes: "
           "true} to all of them, or large_amplitudes to none";
  }
  return "";
}

/// Empty where bodies with large amplitudes can have the joint.
std::string obstacle_to_large_amplitudes(const Joint& joint) {
  if (joint.type != JointType::hinge && !joint.shank) {
    return "";
  }
  return fmt::format(
      "large_amplitudes work with glue, springs and bolts without a shank only, not with a {}: leave out "
      "large_amplitudes, or use model: {{type: finite_elements}}",
      joint.type == JointType::hinge ? "hinge" : "shank");
}

/// [bodies] Whether a body, or one that joints tie to it, has large amplitudes.
std::vector<bool> stretching_with(const Scene& scene) {
  const Solids solids(scene);
  std::vector<bool> result(scene.bodies.size());
  for (const std::vector<std::size_t>& bodies : assemblies(solids)) {
    const bool any =
        std::ranges::any_of(bodies, [&](std::size_t body) { return has_large_amplitudes(scene.bodies[body]); });
    std::ranges::for_each(bodies, [&](std::size_t body) { result[body] = any; });
  }
  return result;
}

}  // namespace

bool read_joints(Section& deck, Scene& scene) {
  Mistakes& mistakes = deck.mistakes();
  const std::size_t before = mistakes.count();
  if (!deck.optional("joints", scene.joints, scene) || scene.bodies.empty()) {
    return false;
  }
  const std::vector<bool> stretches = stretching_with(scene);
  for (const Joint& joint : scene.joints) {
    const bool stretch = stretches[joint.surfaces[0].body];
    if (const std::string why_not = obstacle_to_large_amplitudes(joint); stretch && !why_not.empty()) {
      mistakes.add(joint.where, fmt::format("joints.{}: {}", joint.name, why_not));
    }
    for (const JoinedSurface& surface : joint.surfaces) {
      const std::string why_not = obstacle_to_joint(scene.bodies[surface.body], stretches[surface.body]);
      if (!why_not.empty()) {
        mistakes.add(surface.where,
                     fmt::format("joints.{}: body '{}' {}", joint.name, scene.bodies[surface.body].name, why_not));
      }
    }
  }
  return mistakes.count() == before;
}

}  // namespace idiophone::scene
