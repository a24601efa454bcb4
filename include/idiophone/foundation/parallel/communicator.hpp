#pragma once
// Which rank this is, and of how many.

#include <mpi.h>

#include <array>
#include <string>

namespace idiophone::parallel {

[[nodiscard]] inline int rank_of(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

[[nodiscard]] inline int size_of(MPI_Comm communicator) {
  int size = 0;
  MPI_Comm_size(communicator, &size);
  return size;
}

/// Whether this is rank 0, which reads decks, makes meshes and prints.
[[nodiscard]] inline bool is_root(MPI_Comm communicator) {
  return rank_of(communicator) == 0;
}

/// A communicator of the ranks that share this rank's machine, in the same order.
class RanksOfMachine {
 public:
  /// Collective.
  explicit RanksOfMachine(MPI_Comm communicator) {
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine_);
  }
  RanksOfMachine(const RanksOfMachine&) = delete;
  RanksOfMachine& operator=(const RanksOfMachine&) = delete;
  /// Collective over the ranks of the machine.
  ~RanksOfMachine() { MPI_Comm_free(&machine_); }

  [[nodiscard]] MPI_Comm get() const { return machine_; }

 private:
  MPI_Comm machine_ = MPI_COMM_NULL;
};

/// Whether this is the lowest rank of those that share its machine. Collective.
[[nodiscard]] inline bool is_first_of_machine(MPI_Comm communicator) {
  return is_root(RanksOfMachine(communicator).get());
}

/// The name and version of the MPI library.
[[nodiscard]] inline std::string library_version() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  return text.data();
}

}  // namespace idiophone::parallel
