#pragma once
// Velocities of ghosts through memory that all ranks of one machine share. A rank copies the velocities that others
// need into its own piece of that memory and counts up; the others see the count and copy them from there. For some
// dozens of nodes this takes a fraction of the time of a message.

#include <mpi.h>
#include <semaphore.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "velocity_exchange.hpp"

namespace idiophone::motion {

inline constexpr std::size_t cache_line = 64;  ///< bytes; what different ranks write must not share a cache line

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
  [[nodiscard]] bool is_slow() const override { return false; }

 private:
  /// Of a channel, in shared memory. The sender writes the first line in each step, and only reads the second.
  struct Gate {
    alignas(cache_line) std::atomic<std::uint64_t> updates = 0;  ///< how many have been written
    alignas(cache_line) std::atomic<bool> sleeps = false;        ///< the receiver wants to be woken
    sem_t wake{};
  };

  /// Velocities on their way from one rank to another. They are written to two places in turn: a rank that writes one
  /// of them again has received its neighbour's answer to the other one, so the neighbour has read the first.
  struct Channel {
    /// @param memory   shared, at a multiple of a cache line
    /// @param numbers  of the nodes, local
    Channel(char* memory, std::vector<Index> numbers);

    [[nodiscard]] static std::size_t size(std::size_t nodes);  ///< bytes
    [[nodiscard]] std::span<Velocity> place(std::uint64_t update) const;
    /// Tells the receiver that an update is written.
    void open(std::uint64_t update) const;
    /// Returns when the sender has written an update.
    void wait_for(std::uint64_t update) const;
    /// Takes the cache lines of an update back from the neighbour, which has read them, while there is other work.
    void fetch(std::uint64_t update) const;

    std::vector<Index> nodes;  ///< local numbers
    Gate* gate;
    char* places;  ///< of two updates
  };

  MPI_Win window_ = MPI_WIN_NULL;
  std::vector<Channel> outgoing_, incoming_;  ///< [neighbours]
  std::uint64_t updates_ = 0;
};

}  // namespace idiophone::motion
