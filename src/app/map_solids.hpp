#pragma once
// `idiophone map` for bodies of finite elements.

#include <mpi.h>

#include "map_options.hpp"
#include "map_outcome.hpp"

namespace idiophone::app {

/// Makes the maps of all bodies of the deck, one of those that joints tie together; with MapOptions::rescaled, of the
/// one that the other map belongs to. Collective.
void map_solids(const MapOptions& options, MapOutcome& outcome, MPI_Comm communicator);

}  // namespace idiophone::app
