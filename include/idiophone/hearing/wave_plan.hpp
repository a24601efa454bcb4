#pragma once
// The grid of model waves for a scene.

#include <mpi.h>

#include "idiophone/scene/scene.hpp"
#include "idiophone/source/audible_surface.hpp"
#include "idiophone/waves/plan.hpp"

namespace idiophone::hearing {

/// Around all bodies as they are undeformed, and around the obstacles. Collective.
/// @throws std::runtime_error if an unbounded obstacle is not at the floor that reflects sound, or the grid would be
///         too large
[[nodiscard]] waves::Plan wave_plan(const scene::Scene& scene, const source::AudibleSurface& surface,
                                    MPI_Comm communicator);

}  // namespace idiophone::hearing
