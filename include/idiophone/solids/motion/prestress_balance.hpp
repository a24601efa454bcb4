#pragma once
// Whether a body stays at rest under its prestress.

#include <mpi.h>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::motion {

/// Checks that the prestress of each body pulls on nothing that is free to move: its undeformed shape is in
/// equilibrium, as that of a string along its stress whose ends are held. Collective.
/// @param part  of this rank
/// @throws std::runtime_error, pointing at the prestress in the deck, where it is not
void check_prestress(const scene::Solids& solids, const mesh::Part& part, const FiniteElementDynamics& dynamics,
                     MPI_Comm communicator);

}  // namespace idiophone::motion
