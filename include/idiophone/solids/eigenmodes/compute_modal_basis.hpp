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

/// How a body stretches where its modes vibrate by large amplitudes, in as few terms as the tolerance allows. Runs on
/// one rank.
/// @param found      modes of the body with the lumped mass; its supports are springs of the modes
/// @param alone      the body without others, as find_modes() had it, as `part` and `attachments`
/// @param tolerance  share of the energy of stretching that may be left out
[[nodiscard]] modal_bodies::Stretching stretching_of(const Modes& found, const scene::Solids& alone,
                                                     const mesh::Part& part, const motion::Attachments& attachments,
                                                     double tolerance);

}  // namespace idiophone::eigenmodes
