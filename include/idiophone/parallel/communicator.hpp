#pragma once
// Which rank this is, and of how many.

#include <mpi.h>

namespace idiophone::parallel {

[[nodiscard]] inline int rank_of(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

[[nodiscard]] inline int size_of(MPI_Comm communicator) {
  int size = 0;
  MPI_Comm_size(communicator, &size);
  return size;
}

/// Whether this is rank 0, which reads decks, makes meshes and prints.
[[nodiscard]] inline bool is_root(MPI_Comm communicator) {
  return rank_of(communicator) == 0;
}

}  // namespace idiophone::parallel
