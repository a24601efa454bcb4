#pragma once
// Which owned node of which rank each ghost copies, as PETSc's star forest.

#include <petscsf.h>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/part_size.hpp"

namespace idiophone::motion {

/// Roots are the owned nodes, leaves the ghosts, both in the part's order. Collective.
/// @throws std::runtime_error where PETSc refuses an option
[[nodiscard]] parallel::Handle<PetscSF> ghost_exchange(const mesh::Part& part, MPI_Comm communicator);

/// Work of the elements that a rank computes while the velocities of its ghosts travel between machines, in the unit of
/// mesh::work_of_element.
[[nodiscard]] double work_without_ghosts(const mesh::Part& part);

/// What travels of each ghost in each step: its velocity or, because nodes of modal bodies do not move by their
/// velocities times the step, all of its state.
enum class Halo { velocities, states };

/// States where a joint holds a modal body.
[[nodiscard]] Halo halo_of(const scene::Solids& solids);

/// What a rank receives in each step, bytes.
[[nodiscard]] double halo_bytes(const mesh::PartSize& size, Halo halo);

}  // namespace idiophone::motion
