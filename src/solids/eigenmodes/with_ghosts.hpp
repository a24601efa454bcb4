#pragma once
// Vectors at the owned nodes of a part, and copies at its ghosts.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::eigenmodes {

/// The values of all local nodes. Collective.
/// @param owned  [3 x owned nodes]
/// @return [3 x local nodes]
/// @throws std::runtime_error where PETSc can't
[[nodiscard]] std::vector<double> with_ghosts(const mesh::Part& part, std::span<const double> owned,
                                              MPI_Comm communicator);

}  // namespace idiophone::eigenmodes
