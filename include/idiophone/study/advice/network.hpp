#pragma once
// What `check --ranks` assumes of the exchange between ranks.

#include <thread>

namespace idiophone::advice {

/// How fast ranks exchange messages.
struct Network {
  double latency = 2e-6;          ///< of a message, s
  double bandwidth = 1e10;        ///< of a rank, bytes/s
  bool is_shared_memory = false;  ///< of one machine: then no work is done during the exchange
};

/// Shared memory, as measured, if this machine has a processor for each rank; otherwise a cluster's network.
[[nodiscard]] inline Network usual_network(int ranks) {
  return ranks <= static_cast<int>(std::thread::hardware_concurrency())
             ? Network{.latency = 4e-7, .is_shared_memory = true}
             : Network{};
}

}  // namespace idiophone::advice
