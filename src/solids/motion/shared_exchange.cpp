#include "shared_exchange.hpp"

#include <algorithm>
#include <ctime>
#include <exception>
#include <new>
#include <numeric>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/messages.hpp"

namespace idiophone::motion {

namespace {

constexpr int shared_by_processes = 1;
enum Tag : int { tag_nodes, tag_offset };

/// Number of times that a waiting rank reads the count before it sleeps: some fifty microseconds, more than ranks
/// differ in a step.
constexpr int patience = 200'000;

/// Of the velocities of one update, so that the next begins with a cache line.
std::size_t bytes_of_update(std::size_t nodes) {
  return (nodes * 3 * sizeof(double) + cache_line - 1) / cache_line * cache_line;
}

/// A millisecond from now.
timespec soon() {
  constexpr long second = 1'000'000'000;  // ns
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  const long end = time.tv_nsec + second / 1000;
  return {.tv_sec = time.tv_sec + end / second, .tv_nsec = end % second};
}

/// Another rank, with the local numbers of the nodes that it gets and gives.
struct Neighbour {
  int rank;
  std::vector<Index> sent, received;
};

std::vector<Neighbour> find_neighbours(const mesh::Part& part, MPI_Comm communicator) {
  const int ranks = parallel::size_of(communicator);
  std::vector<std::vector<Index>> received(ranks);
  std::vector<std::vector<Index>> wanted(ranks);
  for (std::size_t ghost = 0; ghost < part.ghost_rank.size(); ++ghost) {
    received[part.ghost_rank[ghost]].push_back(part.owned_nodes + static_cast<Index>(ghost));
    wanted[part.ghost_rank[ghost]].push_back(part.ghost_index[ghost]);
  }
  parallel::Messages messages(communicator);
  for (int rank = 0; rank < ranks; ++rank) {
    messages.send(std::move(wanted[rank]), rank, tag_nodes);
  }
  std::vector<Neighbour> neighbours;
  for (int rank = 0; rank < ranks; ++rank) {
    std::vector<Index> sent = messages.receive<Index>(rank, tag_nodes);
    if (!sent.empty()) {
      neighbours.push_back({rank, std::move(sent), std::move(received[rank])});
    }
  }
  return neighbours;
}

}  // namespace

SharedExchange::Channel::Channel(char* memory, std::vector<Index> numbers)
    : nodes(std::move(numbers)), gate(reinterpret_cast<Gate*>(memory)), places(memory + sizeof(Gate)) {}

std::size_t SharedExchange::Channel::size(std::size_t nodes) {
  return sizeof(Gate) + 2 * bytes_of_update(nodes);
}

std::span<Velocity> SharedExchange::Channel::place(std::uint64_t update) const {
  char* begin = places + update % 2 * bytes_of_update(nodes.size());
  return {reinterpret_cast<Velocity*>(begin), nodes.size()};
}

void SharedExchange::Channel::fetch(std::uint64_t update) const {
  const char* begin = places + update % 2 * bytes_of_update(nodes.size());
  for (std::size_t line = 0; line < bytes_of_update(nodes.size()); line += cache_line) {
    __builtin_prefetch(begin + line, 1);
  }
}

void SharedExchange::Channel::open(std::uint64_t update) const {
  gate->updates.store(update, std::memory_order_release);
  if (gate->sleeps.load(std::memory_order_relaxed)) {
    gate->sleeps.store(false, std::memory_order_relaxed);
    sem_post(&gate->wake);
  }
}

// On a machine with other work the sender may have to wait for a processor. A rank that sleeps leaves its own processor
// to the sender, and runs at once when it is woken. A rank that yields would have to wait for all other programs.
void SharedExchange::Channel::wait_for(std::uint64_t update) const {
  for (int tries = 0; gate->updates.load(std::memory_order_acquire) < update; ++tries) {
    if (tries < patience) {
      continue;
    }
    gate->sleeps.store(true);
    if (gate->updates.load() < update) {
      // The sender does not wake this rank if it looked a moment too early, so this rank looks again after a
      // millisecond.
      const timespec end = soon();
      sem_clockwait(&gate->wake, CLOCK_MONOTONIC, &end);
    }
  }
}

SharedExchange::SharedExchange(const mesh::Part& part, MPI_Comm communicator) {
  static_assert(decltype(Gate::updates)::is_always_lock_free, "ranks can't share a lock");
  const std::vector<Neighbour> neighbours = find_neighbours(part, communicator);
  std::size_t bytes = cache_line;  // MPI's memory may begin within a cache line
  for (const Neighbour& neighbour : neighbours) {
    bytes += Channel::size(neighbour.sent.size());
  }
  char* own = nullptr;
  MPI_Win_allocate_shared(static_cast<MPI_Aint>(bytes), 1, MPI_INFO_NULL, communicator, static_cast<void*>(&own),
                          &window_);
  std::size_t offset = (cache_line - reinterpret_cast<std::uintptr_t>(own) % cache_line) % cache_line;
  parallel::Messages messages(communicator);
  for (const auto& [rank, sent, received] : neighbours) {
    outgoing_.emplace_back(own + offset, sent);
    Gate* gate = new (outgoing_.back().gate) Gate;
    sem_init(&gate->wake, shared_by_processes, 0);
    messages.send(std::vector{offset}, rank, tag_offset);
    offset += Channel::size(sent.size());
  }
  for (const auto& [rank, sent, received] : neighbours) {
    char* theirs = nullptr;
    MPI_Aint size = 0;
    int unit = 0;
    MPI_Win_shared_query(window_, rank, &size, &unit, static_cast<void*>(&theirs));
    incoming_.emplace_back(theirs + messages.receive<std::size_t>(rank, tag_offset)[0], received);
  }
  MPI_Barrier(communicator);  // all counts are zero
}

SharedExchange::~SharedExchange() {
  // While an error takes the job down, the other ranks may never free it.
  if (std::uncaught_exceptions() == 0) {
    MPI_Win_free(&window_);
  }
}

void SharedExchange::send(std::span<const solid::NodeState> state) {
  ++updates_;
  for (const Channel& to : outgoing_) {
    std::ranges::transform(to.nodes, to.place(updates_).begin(),
                           [&](Index node) { return std::to_array(state[node].velocity); });
    to.open(updates_);
  }
}

void SharedExchange::receive(std::span<solid::NodeState> state) {
  for (const Channel& from : incoming_) {
    from.wait_for(updates_);
    const std::span<const Velocity> place = from.place(updates_);
    for (std::size_t i = 0; i < place.size(); ++i) {
      std::ranges::copy(place[i], state[from.nodes[i]].velocity);
    }
  }
  for (const Channel& to : outgoing_) {
    to.fetch(updates_ + 1);
  }
}

}  // namespace idiophone::motion
