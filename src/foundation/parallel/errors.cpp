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

constexpr auto patience = std::chrono::seconds(3);  ///< of a rank that failed, with those that did not

}  // namespace

void share_failure(MPI_Comm communicator, const std::exception_ptr& failure) {
  int failed = failure ? 1 : 0;
  broadcast(failed, communicator);
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
  if (first != ranks) {
    std::string shared = problem;
    broadcast(shared, communicator, first);
    throw std::runtime_error(shared);
  }
}

}  // namespace idiophone::parallel
