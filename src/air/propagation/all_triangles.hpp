#pragma once
// The triangles of all ranks.

#include <mpi.h>

#include <array>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"

namespace idiophone::propagation {

/// In global order, their vertices globally numbered. Collective.
[[nodiscard]] std::vector<std::array<Index, 3>> all_triangles(const propagation::AudibleSurface& surface,
                                                              MPI_Comm communicator);

}  // namespace idiophone::propagation
