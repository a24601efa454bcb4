#pragma once
// The updates of central differences, a node's whole line of memory at a time.

#include <span>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::solid {

/// What a step does to velocities: v becomes keep v + gain (a + gravity), a the acceleration by forces.
struct Kick {
  double keep;      ///< what damping leaves of the velocity
  double gain;      ///< s
  Vector3 gravity;  ///< m/s2
};

/// @param inverse_mass  [nodes] 1/kg
/// @param force         [nodes] N
/// @param state         [nodes] velocities are changed
void update_velocities(const Kick& kick, std::span<const double> inverse_mass, std::span<const NodeForce> force,
                       std::span<NodeState> state);

/// u becomes u + step v.
void update_displacements(double step, std::span<NodeState> state);

}  // namespace idiophone::solid
