#pragma once
// State that goes through a checkpoint, for tests of archive().

#include "idiophone/store/checkpoint_archive.hpp"
#include "shared_folder.hpp"

namespace idiophone::support {

/// Saves on all ranks. Collective.
/// @param state  whose archive(parallel::Archive&, more...) is called
/// @return the checkpoint
template <class State, class... More>
std::filesystem::path save(const Folder& folder, State& state, const More&... more) {
  store::CheckpointWriter writer(folder.path(), {"version", "mesh", "deck", {}}, {.step = 1, .sample = 1},
                                 MPI_COMM_WORLD);
  store::SavingArchive archive(writer, MPI_COMM_WORLD);
  state.archive(archive, more...);
  return writer.commit(1);
}

/// Restores on the ranks of a communicator.
template <class State, class... More>
void restore(const std::filesystem::path& checkpoint, MPI_Comm communicator, State& state, const More&... more) {
  const store::CheckpointReader reader(checkpoint, communicator);
  store::RestoringArchive archive(reader, communicator);
  state.archive(archive, more...);
}

}  // namespace idiophone::support
