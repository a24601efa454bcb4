#pragma once
// Errors and texts that all ranks share. A rank that fails alone would leave the others waiting in the next collective
// call; so each step that can fail on one rank is followed by an agreement.

#include <mpi.h>

#include <exception>
#include <string>
#include <vector>

namespace idiophone::parallel {

[[nodiscard]] int rank_of(MPI_Comm communicator);
[[nodiscard]] int size_of(MPI_Comm communicator);

/// The text that rank 0 has, on all ranks.
[[nodiscard]] std::string broadcast(std::string text, MPI_Comm communicator);
[[nodiscard]] std::vector<std::string> broadcast(const std::vector<std::string>& texts, MPI_Comm communicator);

/// @param problem  what went wrong on this rank; empty for nothing
/// @throws std::runtime_error on every rank, with the lowest failing rank's problem, if any rank has one.
void agree(const std::string& problem, MPI_Comm communicator);

/// Runs an action on every rank; if it throws on any, throws on all. The action may hold one collective call that can
/// fail on single ranks, as its last.
template <class Action>
void collectively(MPI_Comm communicator, const Action& action) {
  std::string problem;
  try {
    action();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  agree(problem, communicator);
}

/// Runs an action on rank 0; if it throws, throws on all ranks.
template <class Action>
void on_rank_0(MPI_Comm communicator, const Action& action) {
  collectively(communicator, [&] {
    if (rank_of(communicator) == 0) {
      action();
    }
  });
}

}  // namespace idiophone::parallel
