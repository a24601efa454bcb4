#include "idiophone/foundation/parallel/errors.hpp"

#include "idiophone/foundation/parallel/broadcast.hpp"

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
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator);
  if (first != ranks) {
    std::string shared = problem;
    broadcast(shared, communicator, first);
    throw std::runtime_error(shared);
  }
}

}  // namespace idiophone::parallel
