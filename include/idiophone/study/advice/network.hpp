#pragma once
// What `check --ranks` assumes of the exchange between ranks.

#include <thread>

namespace idiophone::advice {

/// How fast ranks exchange messages.
struct Network {
  double latency = 2e-6;    ///< of a message, s
  double bandwidth = 1e10;  ///< of a rank, bytes/s
};

/// Of shared memory, as measured, if this machine has a processor for each rank; otherwise of a cluster's network. s
[[nodiscard]] inline double usual_latency(int ranks) {
  return ranks <= static_cast<int>(std::thread::hardware_concurrency()) ? 4e-7 : Network{}.latency;
}

}  // namespace idiophone::advice
