#pragma once
// What resists the turning of a hinge. With e_1 and e_2 directions of the two bodies, at right angles to the axis and,
// at rest, to each other, the sine of the angle is s = e_1 . e_2. The energy is W = k s^2/2, and the forces are minus
// its gradient. Damping adds tau s' to s. s does not change when everything moves rigidly, so both conserve momentum
// and angular momentum. Theory: docs/method/joints.md.

#include <Eigen/Core>

#include "idiophone/solids/joints/meshed_joint.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::joints {

class Turning {
 public:
  /// @param joint, point  must outlive this object
  /// @param reference     positions of the nodes, m
  Turning(const MeshedJoint& joint, const JointPoint& point, std::span<const Vector3> reference,
          std::span<const solid::NodeState> state);

  /// J.
  [[nodiscard]] double energy() const { return joint_.normal / 2 * sine_ * sine_; }

  /// As Stretch::stiffness().
  [[nodiscard]] Eigen::MatrixXd stiffness() const;

  /// Calls visit(node, force) for the nodes of both bodies, N.
  template <class Visitor>
  void for_each_force(const Visitor& visit) const {
    const double moment = joint_.normal * (sine_ + joint_.damping * rate_);
    for_each_gradient([&](Index node, const Vector3& gradient) { visit(node, Vector3(-moment * gradient)); });
  }

  /// Calls visit(node, gradient) for the nodes of both bodies, in the order of MeshedJoint::weights_of: of s, 1/m.
  template <class Visitor>
  void for_each_gradient(const Visitor& visit) const {
    for (Index place = point_.first_begin; place < point_.end; ++place) {
      const NodeWeight& weight = joint_.weights[place];
      visit(weight.node, Vector3(weight.slope[0] * direction_[place < point_.second_begin ? 1 : 0]));
    }
  }

 private:
  const MeshedJoint& joint_;
  const JointPoint& point_;
  std::array<Vector3, 2> direction_ = {Vector3::Zero(), Vector3::Zero()};  // [bodies] e, without unit
  double sine_ = 0.0;                                                      // s
  double rate_ = 0.0;                                                      // of s, 1/s
};

}  // namespace idiophone::joints
