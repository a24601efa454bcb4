#pragma once
// What springs, hinges and bolts consist of: ties between points of two anchors, and what resists their turning.

#include <array>
#include <vector>

#include "anchor.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"

namespace idiophone::joints {

/// Two unit vectors, so that the three are at right angles in their order.
[[nodiscard]] std::array<Vector3, 2> across(const Vector3& direction);

/// The parts of two bodies that a joint holds.
struct Anchors {
  const Anchor& one;
  const Anchor& other;
};

/// Adds a tie between two points to the link.
/// @param first, second  [nodes of the anchor] weights of the points
/// @param line           unit vector: normal of the frame that turns with the first anchor
/// @param length         between the points along the line, at rest, m
void append_tie(MeshedJoint& link, const Anchors& anchors, const std::vector<double>& first,
                const std::vector<double>& second, const Vector3& line, double length);

/// A joint that resists the turning of the anchors against each other about the axis at right angles to two directions.
/// @param directions  of the first and the second anchor, unit vectors at right angles
/// @param number      of the joint, as MeshedJoint::joint
/// @param turning     stiffness and damping
[[nodiscard]] MeshedJoint resistance_to_turning(const Anchors& anchors, const std::array<Vector3, 2>& directions,
                                                std::size_t number, const scene::HingeTurning& turning);

}  // namespace idiophone::joints
