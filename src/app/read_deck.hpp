#pragma once
// A deck for the commands that compute its motion.

#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// Reads and validates a deck and the files of its heads on all ranks. Collective.
/// @throws deck::DeckError for a wrong deck, on rank 0, and parallel::RemoteFailure elsewhere
[[nodiscard]] scene::Scene read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                                     MPI_Comm communicator);

/// Index of a body of the deck. @param name  empty for the first
/// @throws std::runtime_error, with the names of the deck's bodies, if there is none of this name
[[nodiscard]] std::size_t find_body(const scene::Scene& scene, const std::string& name);

}  // namespace idiophone::app
