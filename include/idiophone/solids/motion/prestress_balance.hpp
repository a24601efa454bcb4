#pragma once
// Whether a body keeps its undeformed shape under its prestress.

#include <mpi.h>

#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::motion {

/// Whether the prestress of each body deforms it: it stretches the body, or pulls on nodes that are free to move. A
/// string whose ends are held stays as it is under a stress along it. Collective.
/// @param part  of this rank
/// @return [bodies] 1: deformed; 0: not
[[nodiscard]] std::vector<char> deformed_by_prestress(const scene::Solids& solids, const mesh::Part& part,
                                                      const FiniteElementDynamics& dynamics, MPI_Comm communicator);

}  // namespace idiophone::motion
