#pragma once
// Ghosts kept up to date through memory that all ranks of one machine share. A rank copies the states that others need
// into its own piece of that memory and counts up; the others see the count and copy them from there. For some dozens
// of nodes this takes a fraction of the time of a message.

#include <mpi.h>

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/mesh/part.hpp"
#include "idiophone/solid/node.hpp"

namespace idiophone::motion {

class SharedExchange {
 public:
  /// Collective. Between two ranks, there must be ghosts either in both directions or in none.
  SharedExchange(const mesh::Part& part, MPI_Comm communicator);
  ~SharedExchange();
  SharedExchange(const SharedExchange&) = delete;
  SharedExchange& operator=(const SharedExchange&) = delete;
  SharedExchange(SharedExchange&&) = delete;
  SharedExchange& operator=(SharedExchange&&) = delete;

  /// Sends the owned nodes that are ghosts elsewhere, and receives this rank's ghosts. Waits for its neighbours only.
  /// @param state  [local nodes]
  void update(std::span<solid::NodeState> state);

 private:
  /// States on their way from one rank to another. They are written to two places in turn: a rank that writes one of
  /// them again has received its neighbour's answer to the other one, so the neighbour has read the first.
  struct Channel {
    /// @param memory   shared, at a multiple of a cache line
    /// @param numbers  of the nodes, local
    Channel(char* memory, std::vector<Index> numbers);

    [[nodiscard]] std::span<solid::NodeState> place(std::uint64_t update) const {
      return {places + update % 2 * nodes.size(), nodes.size()};
    }

    std::vector<Index> nodes;             ///< local numbers
    std::atomic<std::uint64_t>* updates;  ///< how many have been written
    solid::NodeState* places;             ///< [2 x nodes]
  };

  MPI_Win window_ = MPI_WIN_NULL;
  std::vector<Channel> outgoing_, incoming_;  ///< [neighbours]
  std::uint64_t updates_ = 0;
};

/// Whether all ranks run on one machine and so can share memory, unless PETSc's option -ghosts_by_messages says no.
/// Collective.
/// @throws std::runtime_error where PETSc refuses an option
[[nodiscard]] bool share_memory(MPI_Comm communicator);

}  // namespace idiophone::motion
