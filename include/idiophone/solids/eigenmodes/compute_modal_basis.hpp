#pragma once
// The modes of a body that is to move by them.

#include <span>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/joined_motion.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/modal_bodies/modal_basis.hpp"

namespace idiophone::eigenmodes {

/// Finds the modes that the body's model asks for, and the residual flexibility of those it leaves out. Runs on one
/// rank.
/// @param body    of the scene, with a modal model
/// @param mesh    of the body
/// @param loaded  nodes of the mesh, ascending, that forces may act on
/// @param joined  if joints hold the body: its motion there, for which further modes follow those of the model
/// @throws deck::DeckError, pointing at the model, where the body is neither held nor free, or the mesh does not have
///         these modes
[[nodiscard]] modal_bodies::ModalBasis modal_basis(const scene::Solids& solids, std::size_t body,
                                                   const mesh::Mesh& mesh, std::span<const Index> loaded,
                                                   const JoinedMotion* joined = nullptr);

/// The modes of bodies that joints tie together, all of them with large amplitudes: the modes of the assembly, which
/// they have in common (scene::has_common_modes). Its stretching is that of the first body. Runs on one rank.
/// @param bodies  of the assembly, ascending
/// @param meshes  of these bodies, without Mesh::beside
/// @param loaded  [these bodies] nodes of the mesh, ascending, that forces may act on
/// @return one basis for each of these bodies
/// @throws deck::DeckError, pointing at the model that asks for the highest modes, where nothing holds the assembly or
/// it
///         does not have these modes, and pointing at a prestress that deforms a body
[[nodiscard]] std::vector<modal_bodies::ModalBasis> common_bases(const scene::Solids& solids,
                                                                 const std::vector<std::size_t>& bodies,
                                                                 const std::vector<mesh::Mesh>& meshes,
                                                                 std::span<const std::vector<Index>> loaded);

/// How bodies that joints tie together stretch where its modes vibrate by large amplitudes, in as few terms as the
/// tolerance allows. Runs on one rank.
/// @param found      modes with the lumped mass; supports are springs of the modes
/// @param alone      a body, or all that joints tie together, as find_modes() had it, as `part` and `attachments`
/// @param tolerance  share of the energy of stretching that may be left out
[[nodiscard]] modal_bodies::Stretching stretching_of(const Modes& found, const scene::Solids& alone,
                                                     const mesh::Part& part, const motion::Attachments& attachments,
                                                     double tolerance);

}  // namespace idiophone::eigenmodes
