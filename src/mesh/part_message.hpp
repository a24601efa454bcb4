#pragma once
// Carries a part from rank 0 to the rank it is for.

#include "idiophone/mesh/part.hpp"

namespace idiophone::mesh {

void send_part(const Part& part, int rank, MPI_Comm communicator);

/// Receives what rank 0 sends with send_part.
[[nodiscard]] Part receive_part(MPI_Comm communicator);

}  // namespace idiophone::mesh
