#include "idiophone/parallel/on_root.hpp"

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
  std::string message = failure ? message_of(failure) : "";
  int length = failure ? static_cast<int>(message.size()) : -1;
  MPI_Bcast(&length, 1, MPI_INT, 0, communicator);
  if (length < 0) {
    return;
  }
  message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(message.data(), length, MPI_CHAR, 0, communicator);
  if (failure) {
    std::rethrow_exception(failure);
  }
  throw RemoteFailure(message);
}

}  // namespace idiophone::parallel
