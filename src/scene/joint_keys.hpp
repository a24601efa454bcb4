#pragma once
// The keys of bolts, springs and hinges: what they have of their own besides between and damping.

#include <vector>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

/// A relaxation time.
inline constexpr Range joint_damping{.at_least = 0.0, .at_most = 1e3, .unit = "s"};

/// The word rigid, or {normal, tangential}, Pa/m; none for rigid.
bool read_layer_stiffness(Section& section, std::optional<JointStiffness>& stiffness);

/// The key material: an isotropic one, whose damping the joint has unless it has its own. Null after a mistake.
const Material* read_joint_material(Section& section, Joint& joint, const std::vector<Material>& materials);

/// [[x, y, z], [x, y, z]], two points
bool read(const Node& node, Mistakes& mistakes, JointAxis& axis);

/// radius; with shank: axis, material, preload; without: at, stiffness, reach
void read_bolt(Section& section, Joint& joint, const std::vector<Material>& materials);

/// stiffness, at, radius
void read_spring(Section& section, Joint& joint);

/// axis, stiffness, turning
void read_hinge(Section& section, Joint& joint);

}  // namespace idiophone::scene
