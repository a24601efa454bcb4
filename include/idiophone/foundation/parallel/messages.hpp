#pragma once
// Messages between single ranks, without waiting for anybody who has no part in them.

#include <mpi.h>

#include <memory>
#include <utility>
#include <vector>

#include "idiophone/foundation/parallel/datatype.hpp"

namespace idiophone::parallel {

/// Messages on their way. The destructor waits until all have left.
class Messages {
 public:
  explicit Messages(MPI_Comm communicator) : communicator_(communicator) {}
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;
  Messages(Messages&&) = delete;
  Messages& operator=(Messages&&) = delete;
  ~Messages() { MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); }

  /// Sends without waiting for the receiver.
  template <class Value>
  void send(std::vector<Value> message, int rank, int tag) {
    const ItemType<Value> type;
    const auto kept = std::make_shared<const std::vector<Value>>(std::move(message));
    MPI_Isend(kept->data(), static_cast<int>(kept->size()), type.get(), rank, tag, communicator_,
              &requests_.emplace_back());
    kept_.push_back(kept);
  }

  /// Waits for a message of any size.
  template <class Value>
  [[nodiscard]] std::vector<Value> receive(int rank, int tag) const {
    const ItemType<Value> type;
    MPI_Status status;
    MPI_Probe(rank, tag, communicator_, &status);
    int size = 0;
    MPI_Get_count(&status, type.get(), &size);
    std::vector<Value> message(size);
    MPI_Recv(message.data(), size, type.get(), rank, tag, communicator_, MPI_STATUS_IGNORE);
    return message;
  }

 private:
  MPI_Comm communicator_;
  std::vector<std::shared_ptr<const void>> kept_;  ///< until they have left
  std::vector<MPI_Request> requests_;
};

}  // namespace idiophone::parallel
