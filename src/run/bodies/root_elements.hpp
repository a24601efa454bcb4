#pragma once
// Which elements rank 0 needs where each rank reads its part of the meshes.

#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::bodies {

/// Nodes whose elements rank 0 needs: those of surfaces that may touch, for the skins of contacts; those of joined
/// groups; and all nodes of bodies that a pluck or a prestress deforms, alone or through joints, for the static
/// equilibrium.
/// @param outlines  of the bodies, without elements
/// @return [bodies] numbers in the body, ascending
/// @throws deck::DeckError where a joint names a group that its body lacks
[[nodiscard]] std::vector<std::vector<Index>> nodes_of_root_elements(const scene::Scene& scene,
                                                                     const std::vector<mesh::Mesh>& outlines);

}  // namespace idiophone::bodies
