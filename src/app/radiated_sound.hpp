#pragma once
// The sound of a body's vibrations, by boundary elements.

#include <mpi.h>

#include "acoustic_surface.hpp"
#include "idiophone/store/radiation_file.hpp"

namespace idiophone::app {

/// Vibrations of one frequency are solved together; frequencies are dealt to the ranks, so the bits do not depend on
/// their number. Collective.
/// @param surface, vibrations  the same on all ranks
[[nodiscard]] store::Radiation radiated_sounds(const scene::Scene& scene, std::size_t body,
                                               const AcousticSurface& surface, const std::vector<Vibration>& vibrations,
                                               MPI_Comm communicator);

}  // namespace idiophone::app
