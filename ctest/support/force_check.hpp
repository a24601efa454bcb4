#pragma once
// Checks of nodal forces.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"
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

/// Expects a tangent stiffness to be minus the derivative of nodal forces.
/// @param tangent     [3 x nodes, 3 x nodes] N/m
/// @param nodes       of the tangent, in the order of its rows
/// @param state       its displacements are changed and put back
/// @param add_force   adds the forces of the state
/// @param difference  its stride is one of columns, its tolerance that of a column, N/m
template <class AddForce>
void expect_tangent(const Eigen::MatrixXd& tangent, std::span<const Index> nodes, std::span<solid::NodeState> state,
                    const AddForce& add_force, const CentralDifference& difference) {
  const auto forces = [&] {
    std::vector<solid::NodeForce> all(state.size());
    add_force(all);
    Eigen::VectorXd found(tangent.rows());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      found.segment<3>(static_cast<Eigen::Index>(3 * a)) = Vector3::Map(all[nodes[a]].component);
    }
    return found;
  };
  for (Eigen::Index column = 0; column < tangent.cols(); column += static_cast<Eigen::Index>(difference.stride)) {
    double& u = state[nodes[column / 3]].displacement[column % 3];
    const double here = u;
    u = here - difference.step;
    const Eigen::VectorXd below = forces();
    u = here + difference.step;
    const Eigen::VectorXd slope = (below - forces()) / (2 * difference.step);
    u = here;
    EXPECT_LT((tangent.col(column) - slope).norm(), difference.tolerance) << "component " << column;
  }
}

}  // namespace idiophone::support
