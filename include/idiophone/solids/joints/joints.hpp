#pragma once
// Forces of joints on this rank's nodes. A rank computes every point that has one of its nodes, and adds the forces in
// the order of the points, so that the sums do not depend on the parts.

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::joints {

class Joints {
 public:
  /// @param joints  in global node numbers
  /// @param part    must outlive this object, and hold all nodes of the points that have an owned one (coupled_nodes)
  Joints(std::span<const MeshedJoint> joints, const mesh::Part& part);

  /// Adds the forces at all local nodes, N; they are complete at the owned ones. Needs the state of the ghosts, too.
  void add_force(std::span<const solid::NodeState> state, std::span<solid::NodeForce> force) const;

  /// Adds the energy stored in the joints, J: the points whose first node is owned here.
  void add_energy(std::span<const solid::NodeState> state, ReproducibleSum& energy) const;

  /// Adds springs and dashpots to the ground, one at each local node, that are at least as stiff and as lossy as the
  /// joints under any motion, N/m and N s/m. [local nodes]
  void add_bounds(std::span<double> stiffness, std::span<double> damping) const;

  /// Calls visit(nodes, matrix) for each point, in their order. The matrix is the stiffness that the point adds to the
  /// undeformed bodies, N/m, row and column 3 a + i for local node a of the list and direction i; symmetric.
  using Visitor = std::function<void(std::span<const Index> nodes, const Eigen::MatrixXd& stiffness)>;
  void for_each_stiffness(std::size_t joint, const Visitor& visit) const;
  /// The same about a state, [local nodes], without the stiffness of damping. Needs the state of the ghosts, too.
  void for_each_stiffness(std::size_t joint, std::span<const solid::NodeState> state, const Visitor& visit) const;

  /// The points that are computed here, in local node numbers.
  [[nodiscard]] std::span<const MeshedJoint> all() const { return joints_; }

  /// Owned nodes that joints act on, ascending.
  [[nodiscard]] std::vector<Index> nodes() const;

 private:
  const mesh::Part& part_;
  std::vector<MeshedJoint> joints_;
};

}  // namespace idiophone::joints
