#pragma once
// Carries a part from rank 0 to the rank it is for.

#include "idiophone/foundation/parallel/messages.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::mesh {

/// Sends without waiting for the receiver.
void send_part(Part part, int rank, parallel::Messages& messages);

/// Receives what rank 0 sends with send_part.
[[nodiscard]] Part receive_part(MPI_Comm communicator);

}  // namespace idiophone::mesh
