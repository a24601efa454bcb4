#pragma once
// Checks of nodal forces.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::support {

/// Largest magnitude of any component, N.
[[nodiscard]] inline double largest_component(std::span<const solid::NodeForce> forces) {
  double largest = 0.0;
  for (const solid::NodeForce& force : forces) {
    for (const double component : force.component) {
      largest = std::max(largest, std::abs(component));
    }
  }
  return largest;
}

/// How an energy is differentiated.
struct CentralDifference {
  std::size_t stride = 1;  ///< every how many nodes, each in one direction
  double step = 0.0;       ///< to either side, m
  double tolerance = 0.0;  ///< of a force, as a part of the largest
};

/// Expects forces to be minus the gradient of an energy.
/// @param state   its displacements are changed and put back
/// @param energy  of the state, J
template <class Energy>
void expect_minus_gradient(std::span<solid::NodeState> state, std::span<const solid::NodeForce> forces,
                           const Energy& energy, const CentralDifference& difference) {
  const double scale = largest_component(forces);
  for (std::size_t node = 0; node < state.size(); node += difference.stride) {
    double& u = state[node].displacement[node % 3];
    const double here = u;
    u = here + difference.step;
    const double above = energy();
    u = here - difference.step;
    const double below = energy();
    u = here;
    EXPECT_NEAR(forces[node].component[node % 3] / scale, -(above - below) / (2 * difference.step) / scale,
                difference.tolerance);
  }
}

}  // namespace idiophone::support
