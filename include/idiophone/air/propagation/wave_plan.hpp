#pragma once
// The grid of model waves for a scene.

#include <mpi.h>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/waves/plan.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::propagation {

/// Around all bodies as they are undeformed, and around the obstacles. Collective.
/// @throws std::runtime_error if an unbounded obstacle is not at the floor that reflects sound, or the grid would be
///         too large
[[nodiscard]] waves::Plan wave_plan(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface,
                                    MPI_Comm communicator);

}  // namespace idiophone::propagation
