#include "idiophone/foundation/parallel/errors.hpp"

#include <optional>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/end_job.hpp"

namespace idiophone::parallel {

namespace {

std::string message_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "unknown failure on rank 0";
  }
}

bool failed_together = false;

/// Notes the outcome of an agreement. What destructors agree on while a failure ends the ranks does not undo it.
void note_agreement(bool failed) {
  if (failed || std::uncaught_exceptions() == 0) {
    failed_together = failed;
  }
}

constexpr auto patience = std::chrono::seconds(3);  ///< of a rank that failed, with those that did not

}  // namespace

bool ranks_fail_together() {
  return failed_together;
}

void share_failure(MPI_Comm communicator, const std::exception_ptr& failure) {
  int failed = failure ? 1 : 0;
  broadcast(failed, communicator);
  note_agreement(failed != 0);
  if (failed == 0) {
    return;
  }
  std::string message = failure ? message_of(failure) : "";
  broadcast(message, communicator);
  if (failure) {
    std::rethrow_exception(failure);
  }
  throw RemoteFailure(message);
}

void agree(MPI_Comm communicator, const std::string& problem) {
  const int ranks = size_of(communicator);
  int first = problem.empty() ? ranks : rank_of(communicator);
  {
    std::optional<Deadline> deadline;
    if (!problem.empty() && ranks > 1) {
      deadline.emplace(patience, problem);
    }
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator);
  }
  note_agreement(first != ranks);
  if (first != ranks) {
    std::string shared = problem;
    broadcast(shared, communicator, first);
    throw std::runtime_error(shared);
  }
}

}  // namespace idiophone::parallel
