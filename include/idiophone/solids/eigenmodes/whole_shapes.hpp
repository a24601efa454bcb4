#pragma once
// Mode shapes of all ranks in one place.

#include <mpi.h>

#include <vector>

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"

namespace idiophone::eigenmodes {

/// The shapes on rank 0, in the order of the mesh's nodes: [modes][3 x nodes], m at unit modal mass. Empty on other
/// ranks. Collective.
/// @param part  this rank's share of the body that the modes are of
[[nodiscard]] std::vector<std::vector<double>> whole_shapes(const Modes& found, const mesh::Part& part,
                                                            MPI_Comm communicator);

}  // namespace idiophone::eigenmodes
