#pragma once
// Ghosts kept up to date through memory that all ranks of one machine share. A rank copies the velocities that others
// need into its own piece of that memory and counts up; the others see the count, copy them from there, and move their
// ghosts with them. For some dozens of nodes this takes a fraction of the time of a message.

#include <mpi.h>

#include <array>
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

  /// Sends the velocities of owned nodes that are ghosts elsewhere, receives those of this rank's ghosts, and moves the
  /// ghosts by one step, as their owners do. Waits for its neighbours only.
  /// @param step   dt, s
  /// @param state  [local nodes]
  void advance_ghosts(double step, std::span<solid::NodeState> state);

 private:
  using Velocity = std::array<double, 3>;  ///< m/s

  /// Velocities on their way from one rank to another. They are written to two places in turn: a rank that writes one
  /// of them again has received its neighbour's answer to the other one, so the neighbour has read the first.
  struct Channel {
    /// @param memory   shared, at a multiple of a cache line
    /// @param numbers  of the nodes, local
    Channel(char* memory, std::vector<Index> numbers);

    [[nodiscard]] static std::size_t size(std::size_t nodes);  ///< bytes
    [[nodiscard]] std::span<Velocity> place(std::uint64_t update) const;
    /// Takes the cache lines of an update back from the neighbour, which has read them, while there is other work.
    void fetch(std::uint64_t update) const;

    std::vector<Index> nodes;             ///< local numbers
    std::atomic<std::uint64_t>* updates;  ///< how many have been written
    char* places;                         ///< of two updates
  };

  Index first_ghost_;
  MPI_Win window_ = MPI_WIN_NULL;
  std::vector<Channel> outgoing_, incoming_;  ///< [neighbours]
  std::uint64_t updates_ = 0;
};

/// Whether all ranks run on one machine and so can share memory, unless PETSc's option -ghosts_by_messages says no.
/// Collective.
/// @throws std::runtime_error where PETSc refuses an option
[[nodiscard]] bool share_memory(MPI_Comm communicator);

}  // namespace idiophone::motion
