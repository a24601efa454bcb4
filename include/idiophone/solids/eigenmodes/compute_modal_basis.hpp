#pragma once
// The modes of a body that is to move by them.

#include <span>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/modal_bodies/modal_basis.hpp"

namespace idiophone::eigenmodes {

/// Finds the modes that the body's model asks for, and the residual flexibility of those it leaves out. Runs on one
/// rank.
/// @param body    of the scene, with a modal model
/// @param mesh    of the body
/// @param loaded  nodes of the mesh, ascending, that forces may act on
/// @throws deck::DeckError, pointing at the model, where the body is neither held nor free, or the mesh does not have
///         these modes
[[nodiscard]] modal_bodies::ModalBasis modal_basis(const scene::Solids& solids, std::size_t body,
                                                   const mesh::Mesh& mesh, std::span<const Index> loaded);

}  // namespace idiophone::eigenmodes
