#pragma once
// State that goes through a checkpoint, for tests of archive().

#include "idiophone/run/results/checkpoint_archive.hpp"
#include "shared_folder.hpp"

namespace idiophone::support {

/// Saves on all ranks. Collective.
/// @param state  whose archive(parallel::Archive&, more...) is called
/// @return the checkpoint
template <class State, class... More>
std::filesystem::path save(const Folder& folder, State& state, const More&... more) {
  results::CheckpointWriter writer(folder.path(), {"version", "mesh", "deck", {}}, {.step = 1, .sample = 1},
                                   MPI_COMM_WORLD);
  results::SavingArchive archive(writer, MPI_COMM_WORLD);
  state.archive(archive, more...);
  return writer.commit(1);
}

/// Restores on the ranks of a communicator.
template <class State, class... More>
void restore(const std::filesystem::path& checkpoint, MPI_Comm communicator, State& state, const More&... more) {
  const results::CheckpointReader reader(checkpoint, communicator);
  results::RestoringArchive archive(reader, communicator);
  state.archive(archive, more...);
}

}  // namespace idiophone::support
