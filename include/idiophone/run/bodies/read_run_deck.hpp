#pragma once
// A deck for the commands that compute its motion.

#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"

namespace idiophone::bodies {

/// Reads and validates a deck and the files of its heads on all ranks. Collective.
/// @throws deck::DeckError for a wrong deck, on rank 0, and parallel::RemoteFailure elsewhere
[[nodiscard]] scene::Scene read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                                     MPI_Comm communicator);

}  // namespace idiophone::bodies
