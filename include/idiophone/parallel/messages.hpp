#pragma once
// Messages between single ranks, without waiting for anybody who has no part in them.

#include <mpi.h>

#include <utility>
#include <vector>

#include "idiophone/parallel/datatype.hpp"

namespace idiophone::parallel {

/// Messages of numbers on their way. The destructor waits until all have left.
template <class Number>
class Messages {
 public:
  explicit Messages(MPI_Comm communicator) : communicator_(communicator) {}
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;
  Messages(Messages&&) = delete;
  Messages& operator=(Messages&&) = delete;
  ~Messages() { MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); }

  /// Sends without waiting for the receiver.
  void send(std::vector<Number> message, int rank, int tag) {
    messages_.push_back(std::move(message));
    MPI_Isend(messages_.back().data(), static_cast<int>(messages_.back().size()), number_type<Number>(), rank, tag,
              communicator_, &requests_.emplace_back());
  }

  /// Waits for a message of any size.
  [[nodiscard]] std::vector<Number> receive(int rank, int tag) const {
    MPI_Status status;
    MPI_Probe(rank, tag, communicator_, &status);
    int size = 0;
    MPI_Get_count(&status, number_type<Number>(), &size);
    std::vector<Number> message(size);
    MPI_Recv(message.data(), size, number_type<Number>(), rank, tag, communicator_, MPI_STATUS_IGNORE);
    return message;
  }

 private:
  MPI_Comm communicator_;
  std::vector<std::vector<Number>> messages_;
  std::vector<MPI_Request> requests_;
};

}  // namespace idiophone::parallel
