#include "idiophone/parallel/collective.hpp"

#include <cstdint>
#include <stdexcept>

namespace idiophone::parallel {

namespace {

void broadcast_from(int root, std::string& text, MPI_Comm communicator) {
  auto length = static_cast<std::int64_t>(text.size());
  MPI_Bcast(&length, 1, MPI_INT64_T, root, communicator);
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, root, communicator);
}

}  // namespace

int rank_of(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

int size_of(MPI_Comm communicator) {
  int size = 0;
  MPI_Comm_size(communicator, &size);
  return size;
}

std::string broadcast(std::string text, MPI_Comm communicator) {
  broadcast_from(0, text, communicator);
  return text;
}

std::vector<std::string> broadcast(const std::vector<std::string>& texts, MPI_Comm communicator) {
  auto count = static_cast<std::int64_t>(texts.size());
  MPI_Bcast(&count, 1, MPI_INT64_T, 0, communicator);
  std::vector<std::string> shared(static_cast<std::size_t>(count));
  if (rank_of(communicator) == 0) {
    shared = texts;
  }
  for (auto& text : shared) {
    broadcast_from(0, text, communicator);
  }
  return shared;
}

void agree(const std::string& problem, MPI_Comm communicator) {
  const int nobody = size_of(communicator);
  int first = problem.empty() ? nobody : rank_of(communicator);
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator);
  if (first != nobody) {
    std::string shared = problem;
    broadcast_from(first, shared, communicator);
    throw std::runtime_error(shared);
  }
}

}  // namespace idiophone::parallel
