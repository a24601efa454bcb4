#pragma once
// Which part of a body a spring, a hinge or a bolt holds.

#include <array>
#include <string>
#include <vector>

#include "anchor.hpp"
#include "idiophone/scene/joint_section.hpp"
#include "idiophone/solids/joints/held_parts.hpp"

namespace idiophone::joints {

/// The elements behind both surfaces of the joint, or behind some of their faces: those around the place of a spring,
/// or those whose middles lie under the washers of a bolt.
/// @throws deck::DeckError, pointing at a surface, where its group has no face, it has too many nodes, or the end of a
///         bolt's axis is farther from it than the washer is wide; pointing at the place of a spring that is far from
///         both
[[nodiscard]] std::array<HeldPart, 2> held_by(const scene::Joint& joint, const std::vector<mesh::Mesh>& meshes);

/// What to do where a joint holds too many nodes.
[[nodiscard]] std::string how_to_hold_less(const scene::Joint& joint);

/// @throws deck::DeckError where the end of a hinge's axis is far from what the hinge holds
void require_hinge_near(const scene::Joint& joint, const scene::JoinedSurface& surface, const Vector3& end,
                        const Anchor& anchor);

}  // namespace idiophone::joints
