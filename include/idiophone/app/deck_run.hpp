#pragma once
// From a deck to sound.

#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/run/loop/progress.hpp"

namespace idiophone::app {

/// What an accelerator computes.
enum class Accelerated {
  all,       ///< whatever it can
  waves,     ///< waves on a grid
  elements,  ///< finite elements
};

struct RunOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;  ///< KEY.PATH=VALUE
  std::filesystem::path output = "results";
  bool resume = false;          ///< go on from the newest checkpoint
  std::filesystem::path scene;  ///< a sonic scene whose sounds are made, too; empty for none
  loop::ProgressWish progress = loop::ProgressWish::automatic;
  std::string accelerator = {};  ///< as accelerator::Accelerator takes it; empty for none
  Accelerated accelerated = Accelerated::all;
};

/// Runs a deck; writes NAME.h5, NAME.wav and NAME_checkpoints into the output folder. Collective.
/// @return the exit status: loop::exit_finished or loop::exit_resumable
/// @throws deck::DeckError for a wrong deck, on rank 0, and parallel::RemoteFailure elsewhere; std::runtime_error
[[nodiscard]] int run_deck(const RunOptions& options, MPI_Comm communicator);

}  // namespace idiophone::app
