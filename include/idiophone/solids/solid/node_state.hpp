#pragma once
// What the solid keeps at a node: one 64-byte cache line of state, and the force on it.

namespace idiophone::solid {

/// Motion of one node, in one cache line.
struct alignas(64) NodeState {
  double displacement[3] = {};  ///< u = x - X, m, at time t_n
  double velocity[3] = {};      ///< v, m/s, at the half step t_{n-1/2}
  double unused[2] = {};
};

/// Force on one node, N; the fourth component keeps it aligned and means nothing.
struct alignas(32) NodeForce {
  double component[4] = {};
};

}  // namespace idiophone::solid
