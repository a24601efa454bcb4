#pragma once
// Work that only rank 0 can do (read a deck, make a mesh), and whose failure must stop every rank and hang none.

#include <mpi.h>

#include <exception>
#include <stdexcept>
#include <string>

namespace idiophone::parallel {

/// Rank 0 failed; what() is what it said. Rank 0 itself throws the original, so the other ranks need not print this.
class RemoteFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Tells all ranks how rank 0 fared. Collective.
/// @param failure  on rank 0, the exception it caught or none; ignored elsewhere
/// @throws the failure itself on rank 0, RemoteFailure with its message on the others
void share_failure(MPI_Comm communicator, const std::exception_ptr& failure);

/// Calls `work()` on rank 0 only. Collective: returns or throws on every rank.
/// @throws what `work` throws on rank 0, RemoteFailure with its message on the others
template <class Work>
void on_root(MPI_Comm communicator, Work&& work) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::exception_ptr failure;
  if (rank == 0) {
    try {
      std::forward<Work>(work)();
    } catch (...) {
      failure = std::current_exception();
    }
  }
  share_failure(communicator, failure);
}

}  // namespace idiophone::parallel
