#pragma once
// What `check --ranks` assumes of the exchange between ranks.

#include <thread>

namespace idiophone::advice {

/// How fast ranks exchange messages: the model LogGP of Alexandrov, Ionescu, Schauser and Scheiman (1995), without gaps
/// between messages.
struct Network {
  double latency = 2e-6;          ///< from the call that sends a message to the end of the one that receives it, s
  double overhead = 3e-7;         ///< of it, processor time at each end, s
  double bandwidth = 1e10;        ///< of a host in each direction, bytes/s
  int ranks_on_host = 1;          ///< they exchange through its memory: ranks 0 to n-1, n to 2n-1, ...
  bool is_shared_memory = false;  ///< all ranks run on one machine: then no work is done during the exchange
};

/// As measured.
inline constexpr Network shared_memory{.latency = 4e-7, .overhead = 2e-7, .is_shared_memory = true};

/// Shared memory if this machine has a processor for each rank; otherwise a cluster's network.
[[nodiscard]] inline Network usual_network(int ranks) {
  return ranks <= static_cast<int>(std::thread::hardware_concurrency()) ? shared_memory : Network{};
}

}  // namespace idiophone::advice
