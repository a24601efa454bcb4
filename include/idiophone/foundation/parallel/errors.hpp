#pragma once
// Errors that all ranks share. A rank that fails alone would leave the others waiting in the next collective call, so
// each step that can fail on one rank is followed by an agreement.

#include <mpi.h>

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "idiophone/foundation/parallel/communicator.hpp"

namespace idiophone::parallel {

/// Rank 0 failed; what() is its message. Rank 0 itself throws the original, so the other ranks need not print this.
class RemoteFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Sends rank 0's failure to all ranks. Collective.
/// @param failure  on rank 0, the exception it caught or none; ignored elsewhere
/// @throws the failure itself on rank 0, RemoteFailure with its message on the others
void share_failure(MPI_Comm communicator, const std::exception_ptr& failure);

/// Calls `work()` on rank 0 only. Collective: returns or throws on every rank.
/// @throws what `work` throws on rank 0, RemoteFailure with its message on the others
template <class Work>
void on_root(MPI_Comm communicator, Work&& work) {
  std::exception_ptr failure;
  if (is_root(communicator)) {
    try {
      std::forward<Work>(work)();
    } catch (...) {
      failure = std::current_exception();
    }
  }
  share_failure(communicator, failure);
}

/// Collective. If ranks without a problem do not come within 3 s, they wait in the call that failed on this rank. Then
/// this rank says its problem and leaves with status 1, upon which the launcher ends the job.
/// @param problem  what went wrong on this rank; empty for nothing
/// @throws std::runtime_error on every rank, with the lowest failing rank's problem, if any rank has one
void agree(MPI_Comm communicator, const std::string& problem);

/// Calls `work()` on every rank. It may hold one collective call that can fail on single ranks, as its last. If the
/// others wait in that call for a rank on which it failed, the job ends as agree() says.
/// @throws std::runtime_error on every rank, with the lowest failing rank's message, if it throws on any
template <class Work>
void collectively(MPI_Comm communicator, Work&& work) {
  std::string problem;
  try {
    std::forward<Work>(work)();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  agree(communicator, problem);
}

}  // namespace idiophone::parallel
