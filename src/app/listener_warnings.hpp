#pragma once
// What several commands warn of listeners.

#include <mpi.h>

#include <string>

#include "idiophone/air/propagation/placement.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// Listeners that move, and heads, where neither reaches the outcome.
/// @param outcome  "the map"
void warn_of_still_listeners(const scene::Scene& scene, const std::string& outcome);

/// Listeners and bodies whose levels are doubtful.
/// @throws deck::DeckError where listeners or bodies are where they can't be
void check_placement(const scene::Scene& scene, const propagation::Surroundings& around, propagation::Hearing hearing);

/// The same for a surface that the radiation model of the scene hears. Collective.
void check_placement(const scene::Scene& scene, const propagation::AudibleSurface& surface, MPI_Comm communicator);

}  // namespace idiophone::app
