#pragma once
// Velocities of ghosts through memory that all ranks of one machine share. A rank copies the velocities that others
// need into its own piece of that memory and counts up; the others see the count and copy them from there. For some
// dozens of nodes this takes a fraction of the time of a message.

#include <mpi.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "velocity_exchange.hpp"

namespace idiophone::motion {

class SharedExchange : public VelocityExchange {
 public:
  /// Collective. Between two ranks, there must be ghosts either in both directions or in none.
  SharedExchange(const mesh::Part& part, MPI_Comm communicator);
  ~SharedExchange() override;
  SharedExchange(const SharedExchange&) = delete;
  SharedExchange& operator=(const SharedExchange&) = delete;
  SharedExchange(SharedExchange&&) = delete;
  SharedExchange& operator=(SharedExchange&&) = delete;

  void send(std::span<const solid::NodeState> state) override;
  void receive(std::span<solid::NodeState> state) override;

 private:
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

  MPI_Win window_ = MPI_WIN_NULL;
  std::vector<Channel> outgoing_, incoming_;  ///< [neighbours]
  std::uint64_t updates_ = 0;
};

}  // namespace idiophone::motion
