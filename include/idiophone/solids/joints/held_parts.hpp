#pragma once
// The parts of bodies that springs, hinges and shanks hold: of a mesh, and the same parts of a refined one.

#include <array>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/faces.hpp"
#include "idiophone/solids/mesh/refined.hpp"

namespace idiophone::joints {

/// Faces of a surface of a joint, and the elements behind them.
struct HeldPart {
  std::vector<mesh::ElementFace> faces;
  std::vector<Index> elements;  ///< ascending

  /// Ascending numbers of the mesh.
  [[nodiscard]] std::vector<Index> nodes(const mesh::Mesh& mesh) const;
};

/// [joints] of each surface; empty parts of layers, which hold no elements.
using HeldParts = std::vector<std::array<HeldPart, 2>>;

/// @throws as find_joints(), where a spring, a hinge or a shank holds too many nodes or lies too far from a surface
[[nodiscard]] HeldParts held_parts(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes);

/// The same parts of the bodies on refined meshes: all elements that those of each part became.
/// @param held  on the given meshes
/// @throws deck::DeckError, pointing at the joint, where both its parts together have more than 2000 nodes: each
///         of them is tied to each
[[nodiscard]] HeldParts refined(const HeldParts& held, const scene::Solids& solids,
                                const std::vector<mesh::Mesh>& meshes,
                                const std::vector<mesh::RefinedMesh>& refined_meshes);

}  // namespace idiophone::joints
