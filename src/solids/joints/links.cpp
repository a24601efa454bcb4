#include "links.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "held_part.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/joints/beam_stiffness.hpp"
#include "link_points.hpp"

namespace idiophone::joints {

namespace {

constexpr double rigid_link = 100;  // N/m, in moduli times the width of the part that is held

struct SpringLine {
  Vector3 direction;  ///< unit vector
  double length;      ///< m
};

/// Between the middles; along the mean normal where these are one place. A surface that faces all ways has no such
/// normal, and its mesh moves its middle a little.
/// @throws deck::DeckError where a spring that pulls differently along and across its line has none
SpringLine line_of(const scene::Joint& joint, const Anchor& one, const Anchor& other) {
  constexpr double least_normal = 0.05;                                   // of the mean normal
  constexpr double same_place = 1e-6, same_place_facing_all_ways = 0.05;  // widths
  const Vector3 line = other.middle() - one.middle();
  const bool has_normal = one.normal().norm() > least_normal;
  if (line.norm() > (has_normal ? same_place : same_place_facing_all_ways) * one.width()) {
    return {line.normalized(), line.norm()};
  }
  if (!has_normal && joint.stiffness->normal != joint.stiffness->tangential) {
    throw deck::DeckError(
        joint.where, fmt::format("joints.{}: the middles of '{}' and '{}' are at the same place, and the surfaces face "
                                 "all ways, so that axial and lateral have no direction: give one number as stiffness, "
                                 "or at and radius of the part of the surfaces that the spring holds",
                                 joint.name, joint.surfaces[0].group, joint.surfaces[1].group));
  }
  return {has_normal ? one.normal().normalized() : Vector3::UnitX(), 0.0};
}

void append_spring(MeshedJoint& link, const scene::Joint& joint, const Anchor& one, const Anchor& other) {
  const SpringLine line = line_of(joint, one, other);
  append_tie(link, {one, other}, one.shares(), other.shares(), line.direction, line.length);
}

void append_hinge(MeshedJoint& link, const scene::Joint& joint, const Anchor& one, const Anchor& other) {
  const Vector3 line = (joint.axis.end - joint.axis.begin).normalized();
  for (const Vector3& end : {joint.axis.begin, joint.axis.end}) {
    require_hinge_near(joint, joint.surfaces[0], end, one);
    require_hinge_near(joint, joint.surfaces[1], end, other);
    append_tie(link, {one, other}, one.weights_at(end), other.weights_at(end), line, 0.0);
  }
}

std::vector<MeshedJoint> mesh_spring_or_hinge(const scene::Joint& joint, std::size_t number, double modulus,
                                              const Anchors& anchors) {
  const auto& [one, other] = anchors;
  const double rigid = rigid_link * modulus * std::min(one.width(), other.width());
  const scene::JointStiffness stiffness = joint.stiffness.value_or(scene::JointStiffness{rigid, rigid});
  MeshedJoint link{.joint = number,
                   .normal = stiffness.normal,
                   .tangential = stiffness.tangential,
                   .damping = joint.damping,
                   .points = {},
                   .weights = {}};
  if (joint.type == scene::JointType::hinge) {
    append_hinge(link, joint, one, other);
  } else {
    append_spring(link, joint, one, other);
  }
  std::vector<MeshedJoint> links = {std::move(link)};
  if (joint.turning) {
    const std::array<Vector3, 2> directions = across((joint.axis.end - joint.axis.begin).normalized());
    links.push_back(resistance_to_turning(anchors, directions, number, *joint.turning));
  }
  return links;
}

/// A beam as springs at its middle: one that ties its two middles together, and one against each turning.
std::vector<MeshedJoint> mesh_shank(const scene::Joint& joint, std::size_t number, const Anchors& anchors) {
  const Vector3 line = joint.axis.end - joint.axis.begin;
  const Vector3 along = line.normalized(), middle = (joint.axis.begin + joint.axis.end) / 2;
  const BeamStiffness beam = beam_stiffness(*joint.shank, line.norm());
  std::vector<MeshedJoint> links = {{.joint = number,
                                     .normal = beam.axial,
                                     .tangential = beam.lateral,
                                     .damping = joint.damping,
                                     .points = {},
                                     .weights = {}}};
  append_tie(links.front(), anchors, anchors.one.weights_at(middle), anchors.other.weights_at(middle), along, 0.0);
  const auto resist = [&](double stiffness, const std::array<Vector3, 2>& directions) {
    links.push_back(resistance_to_turning(anchors, directions, number, {stiffness, joint.damping}));
  };
  const auto [a, b] = across(along);
  resist(beam.torsion, {a, b});
  resist(beam.bending, {along, a});
  resist(beam.bending, {b, along});
  return links;
}

/// @throws deck::DeckError where both ends hold the same elements: what lies between them cannot be seen
void require_two_parts(const scene::Joint& joint, const Anchors& anchors) {
  if (anchors.one.nodes() == anchors.other.nodes()) {
    throw deck::DeckError(joint.where, fmt::format("joints.{}: both ends hold the same elements, so the bolt does "
                                                   "nothing: let it go through several elements, or to another body",
                                                   joint.name));
  }
}

}  // namespace

std::vector<MeshedJoint> mesh_link(const scene::Joint& joint, std::size_t number, double modulus,
                                   const std::vector<mesh::Mesh>& meshes, const std::vector<Index>& first_node,
                                   const std::array<HeldPart, 2>& held) {
  const auto anchor_at = [&](std::size_t side) {
    const std::size_t body = joint.surfaces[side].body;
    return Anchor(meshes[body], held[side], first_node[body]);
  };
  const Anchor one = anchor_at(0), other = anchor_at(1);
  if (!joint.shank) {
    return mesh_spring_or_hinge(joint, number, modulus, {one, other});
  }
  require_two_parts(joint, {one, other});
  return mesh_shank(joint, number, {one, other});
}

}  // namespace idiophone::joints
