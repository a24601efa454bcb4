#pragma once
// The sound of a body's vibrations, by boundary elements.

#include <mpi.h>

#include <optional>

#include "idiophone/air/harmonic/body_radiation.hpp"
#include "idiophone/air/harmonic/body_vibrations.hpp"
#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::harmonic {

struct RadiationOptions {
  std::optional<double> cell = std::nullopt;  ///< of a grid of model waves for comparison, m; none: it is left out
  double tolerance = 0.5;                     ///< dB: the surface is refined until that changes no level by more; 0: it
                                              ///< is not refined
  std::size_t most_vertices = 6000;           ///< that a refined surface may have
};

/// Vibrations of one frequency are solved together; frequencies are dealt to the ranks, so the bits do not depend on
/// their number. Collective.
/// @param part  of the surface, which moves
/// @param surface, vibrations  the same on all ranks
/// @param watch  may end the work: the result then has only the first frequencies, those that all ranks have done
[[nodiscard]] harmonic::Radiation radiated_sounds(const scene::Acoustics& acoustics, std::size_t part,
                                                  const AcousticSurface& surface,
                                                  const std::vector<Vibration>& vibrations,
                                                  const RadiationOptions& options, MPI_Comm communicator,
                                                  const PartWatch& watch = {});

}  // namespace idiophone::harmonic
