#pragma once
// What `check --ranks` assumes of the machines' network.

namespace idiophone::app {

/// How fast ranks exchange messages.
struct Network {
  double latency = 2e-6;    ///< of a message, s
  double bandwidth = 1e10;  ///< of a rank, bytes/s
};

}  // namespace idiophone::app
