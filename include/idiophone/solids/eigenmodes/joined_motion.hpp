#pragma once
// How bodies that joints tie together vibrate, body by body: what a modal body needs to know of it.

#include <map>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::eigenmodes {

/// What one body does in the modes of an assembly.
struct JoinedMotion {
  std::vector<double> frequencies;          ///< [modes of the assembly] w without damping, rad/s
  std::vector<std::vector<double>> shapes;  ///< [modes][3 x nodes of the body], of unit modal mass of the assembly
  std::vector<double> rest;  ///< [3 x nodes of the body] displacements where the assembly rests under its prestress, m;
                             ///< empty: it rests undeformed
  std::vector<double> springs;  ///< [nodes of the body] as Joints::add_bounds(), N/m
};

/// The modes that joints give to modal bodies: those of the bodies they tie together, as finite elements. They reach up
/// to the highest `up_to` of the modal bodies, or are as many as all of these have by `count`. Runs on one rank.
/// @param meshes  of all bodies
/// @return by the number of each modal body that a joint holds, without those of common modes (scene::has_common_modes)
/// @throws deck::DeckError, pointing at a model, where the assembly has no such modes; as Operators where it has no
/// rest
[[nodiscard]] std::map<std::size_t, JoinedMotion> joined_motions(const scene::Solids& solids,
                                                                 const std::vector<mesh::Mesh>& meshes);

}  // namespace idiophone::eigenmodes
