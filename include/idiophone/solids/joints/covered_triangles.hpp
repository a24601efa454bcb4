#pragma once
// The part of the surface that joints cover, and the air does not touch.

#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::joints {

/// The triangles of joined surfaces whose middle faces the other surface of the joint within its reach, on both sides:
/// [triangles of all bodies], 1 where a joint covers it. Call where the meshes are.
/// @throws as find_joints(); deck::DeckError, pointing at the first joint, when no triangle is left
[[nodiscard]] std::vector<char> covered_triangles(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes);

}  // namespace idiophone::joints
