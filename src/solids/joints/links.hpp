#pragma once
// Springs, hinges, and bolts with a shank, on meshes.

#include "idiophone/solids/joints/held_parts.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"

namespace idiophone::joints {

/// A spring, a hinge or a shank: a joint, and another one for each direction in which it resists turning.
/// @param number   of the joint, as MeshedJoint::joint
/// @param modulus  the softest of both bodies, Pa: a rigid hinge is a hundred times as stiff as a piece of it
/// @param held     at its two surfaces
/// @throws as find_joints()
[[nodiscard]] std::vector<MeshedJoint> mesh_link(const scene::Joint& joint, std::size_t number, double modulus,
                                                 const std::vector<mesh::Mesh>& meshes,
                                                 const std::vector<Index>& first_node,
                                                 const std::array<HeldPart, 2>& held);

}  // namespace idiophone::joints
