#pragma once
// Computations in the process of another program, for example Python. They leave its signals, its MPI and its PETSc as
// they are, and never end it for an error that the ranks agree on.

#include <mpi.h>

#include <functional>
#include <stdexcept>

namespace idiophone::app {

/// A deck has mistakes: what() has one in each line. On every rank.
class WrongDeck : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Another failure. On every rank.
class FailedComputation : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run stopped in good order, and can be resumed.
class StoppedRun : public std::runtime_error {
 public:
  explicit StoppedRun(int by) : std::runtime_error("stopped in good order"), signal(by) {}
  int signal;  ///< as loop::noted_signal() on this rank; 0: another rank noted it, or the wall-clock limit is over
};

/// Calls `work`, which returns an exit status (run/loop/stop.hpp), with a duplicate of the communicator. Starts MPI and
/// PETSc if nobody has. While it works, signals are noted; the host gets those that stopped nothing. Collective; other
/// threads that compute wait for its end.
///
/// If a rank fails in the midst of a collective call, so that the others wait for it, the job ends, as
/// parallel::agree() says.
/// @param communicator  a function that gives it, because there is none before MPI is started
/// @throws WrongDeck, StoppedRun; FailedComputation with the message of the lowest rank that failed
void compute_as_guest(const std::function<MPI_Comm()>& communicator, const std::function<int(MPI_Comm)>& work);

/// Whether MPI runs, and has not ended.
[[nodiscard]] bool mpi_runs();

/// Ends what compute_as_guest() has started. Call it before the host ends MPI.
void end_guest();

}  // namespace idiophone::app
