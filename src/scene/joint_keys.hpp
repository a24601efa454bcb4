#pragma once
// The keys of bolts, springs and hinges: what they have of their own besides between and damping.

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

/// A relaxation time.
inline constexpr Range joint_damping{.at_least = 0.0, .at_most = 1e3, .unit = "s"};

/// The word rigid, or {normal, tangential}, Pa/m; none for rigid.
bool read_layer_stiffness(Section& section, std::optional<JointStiffness>& stiffness);

/// at, radius, stiffness, reach; refuses preload.
void read_bolt(Section& section, Joint& joint);

/// stiffness, at, radius
void read_spring(Section& section, Joint& joint);

/// axis, stiffness, turning
void read_hinge(Section& section, Joint& joint);

}  // namespace idiophone::scene
