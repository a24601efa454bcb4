#pragma once
// The stretch of a joint at one point, and what follows from it. With a and b the tangents of the first surface,
// n = a x b/|a x b| its normal, and h the distance at rest, the stretch is d = u_1 + h (n - n_0) - u_2. It is zero
// under every rigid motion. The energy is W = area/2 (k_t |d|^2 + (k_n - k_t) (n.d)^2), and the forces are minus its
// gradient, so they conserve energy, momentum and angular momentum. Theory: docs/method/joints.md.

#include <Eigen/Geometry>

#include "idiophone/solids/joints/meshed_joint.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::joints {

/// Tangents and unit normal of the first surface.
struct SurfaceFrame {
  Vector3 a = Vector3::Zero();
  Vector3 b = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
  double area = 0.0;  ///< |a x b|

  /// From the tangents.
  void find_normal();
};

/// At rest.
[[nodiscard]] SurfaceFrame undeformed_frame(const MeshedJoint& joint, const JointPoint& point,
                                            std::span<const Vector3> reference);

class Stretch {
 public:
  /// @param joint, point  must outlive this object
  /// @param reference     positions of the nodes, m
  Stretch(const MeshedJoint& joint, const JointPoint& point, std::span<const Vector3> reference,
          std::span<const solid::NodeState> state);

  /// J.
  [[nodiscard]] double energy() const { return point_.area / 2 * stretch_.dot(stress_of(stretch_)); }

  /// With which the two sides pull at each other along the normal, N; below zero where they press.
  [[nodiscard]] double pull() const { return -frame_.normal.dot(force_on_second()); }

  /// Of small displacements about this state, without damping, N/m: [3 nodes x 3 nodes], the nodes as
  /// MeshedJoint::weights_of has them; symmetric, without a negative eigenvalue where nothing is stretched.
  [[nodiscard]] Eigen::MatrixXd stiffness() const;

  /// Calls visit(node, force) for the nodes of both surfaces, N.
  template <class Visitor>
  void for_each_force(const Visitor& visit) const {
    const Vector3 force = force_on_second();
    const double difference = point_.area * (joint_.normal - joint_.tangential);
    const Vector3 on_normal = point_.distance * force + difference * frame_.normal.dot(stretch_) * stretch_;
    const Vector3 turning = across(on_normal) / frame_.area;
    const Vector3 on_a = frame_.b.cross(turning);
    const Vector3 on_b = turning.cross(frame_.a);
    for (const NodeWeight& weight : first()) {
      visit(weight.node, -(weight.value * force + weight.slope[0] * on_a + weight.slope[1] * on_b));
    }
    for (const NodeWeight& weight : second()) {
      visit(weight.node, weight.value * force);
    }
  }

 private:
  [[nodiscard]] std::span<const NodeWeight> first() const {
    return std::span(joint_.weights).subspan(point_.first_begin, point_.second_begin - point_.first_begin);
  }
  [[nodiscard]] std::span<const NodeWeight> second() const {
    return std::span(joint_.weights).subspan(point_.second_begin, point_.end - point_.second_begin);
  }
  /// The part at right angles to the normal.
  [[nodiscard]] Vector3 across(const Vector3& vector) const {
    return vector - frame_.normal.dot(vector) * frame_.normal;
  }
  /// N.
  [[nodiscard]] Vector3 force_on_second() const { return point_.area * stress_of(stretch_ + joint_.damping * rate_); }
  /// Pa.
  [[nodiscard]] Vector3 stress_of(const Vector3& stretch) const {
    const double along = frame_.normal.dot(stretch);
    return joint_.tangential * stretch + (joint_.normal - joint_.tangential) * along * frame_.normal;
  }

  /// u_1 - u_2, a and b: the energy depends on the nodes by them.
  using Variables = Eigen::Matrix<double, 9, 1>;
  /// Of the gradient of the energy by the variables, as they change.
  [[nodiscard]] Variables change_of_gradient(const Variables& change) const;

  const MeshedJoint& joint_;
  const JointPoint& point_;
  SurfaceFrame frame_;                 // deformed
  Vector3 stretch_ = Vector3::Zero();  // d, m
  Vector3 rate_ = Vector3::Zero();     // of d, m/s
};

}  // namespace idiophone::joints
