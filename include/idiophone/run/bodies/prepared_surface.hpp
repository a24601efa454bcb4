#pragma once
// The audible surface of bodies that are ready to move.

#include <mpi.h>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/run/bodies/preparation.hpp"

namespace idiophone::bodies {

/// Collective.
[[nodiscard]] propagation::AudibleSurface audible_surface(const Preparation& ready, MPI_Comm communicator);

}  // namespace idiophone::bodies
