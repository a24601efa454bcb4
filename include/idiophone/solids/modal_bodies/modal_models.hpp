#pragma once
// The models of bodies that move by their modes.

#include <mpi.h>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "idiophone/solids/motion/body_model.hpp"

namespace idiophone::modal_bodies {

/// Makes the models of bodies that have a basis; all others consist of finite elements.
/// @param bases  must outlive the maker
[[nodiscard]] motion::ModelMaker modal_models(const scene::Solids& solids, const ModalBases& bases);

/// Rank 0's bases, on every rank, but for their shapes, which stay on rank 0. Collective.
[[nodiscard]] ModalBases broadcast(ModalBases bases, MPI_Comm communicator);

/// Moves the shapes from rank 0 to the ranks that have the bodies. Afterwards, no other rank has them. Collective.
/// @param bases  from broadcast()
/// @param part   of this rank; one rank has all of each body
void move_shapes(ModalBases& bases, const mesh::Part& part, MPI_Comm communicator);

}  // namespace idiophone::modal_bodies
