#pragma once
// Which part of a body a spring, a hinge or a bolt holds.

#include <optional>
#include <vector>

#include "anchor.hpp"
#include "idiophone/scene/joint_section.hpp"

namespace idiophone::joints {

/// The elements behind a surface of the joint, or behind some of its faces: those around the place of a spring, or
/// those whose middles lie under the washer of a bolt.
/// @param end  of the axis of a bolt at this surface; not used otherwise
/// @throws deck::DeckError, pointing at the surface, where its group has no face or it has too many nodes
[[nodiscard]] Anchor held_part(const scene::Joint& joint, const scene::JoinedSurface& surface, const Vector3& end,
                               const mesh::Mesh& mesh, Index first_node);

/// A spring may be long: its place need not be near both surfaces.
/// @throws deck::DeckError where it is far from both
void require_place_near(const scene::Joint& joint, const std::vector<mesh::Mesh>& meshes);

/// @throws deck::DeckError where the end of a hinge's axis is far from what the hinge holds
void require_hinge_near(const scene::Joint& joint, const scene::JoinedSurface& surface, const Vector3& end,
                        const Anchor& anchor);

/// @throws deck::DeckError where the end of a bolt's axis is farther from the surface than its washer is wide
void require_washer_on(const scene::Joint& joint, const scene::JoinedSurface& surface, const Vector3& end,
                       const mesh::Mesh& mesh);

}  // namespace idiophone::joints
