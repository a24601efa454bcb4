#include "joint_stretch.hpp"

namespace idiophone::joints {

SurfaceFrame undeformed_frame(const MeshedJoint& joint, const JointPoint& point, std::span<const Vector3> reference) {
  SurfaceFrame frame;
  for (const NodeWeight& weight : joint.weights_of(point)) {
    frame.a += weight.slope[0] * reference[weight.node];
    frame.b += weight.slope[1] * reference[weight.node];
  }
  frame.find_normal();
  return frame;
}

void SurfaceFrame::find_normal() {
  const Vector3 cross = a.cross(b);
  area = cross.norm();
  normal = cross / area;
}

Stretch::Stretch(const MeshedJoint& joint, const JointPoint& point, std::span<const Vector3> reference,
                 std::span<const solid::NodeState> state)
    : joint_(joint), point_(point) {
  SurfaceFrame rest;
  Vector3 rate_a = Vector3::Zero();
  Vector3 rate_b = Vector3::Zero();
  for (const NodeWeight& weight : first()) {
    const Vector3 displacement(state[weight.node].displacement);
    const Vector3 velocity(state[weight.node].velocity);
    rest.a += weight.slope[0] * reference[weight.node];
    rest.b += weight.slope[1] * reference[weight.node];
    frame_.a += weight.slope[0] * displacement;
    frame_.b += weight.slope[1] * displacement;
    rate_a += weight.slope[0] * velocity;
    rate_b += weight.slope[1] * velocity;
    stretch_ += weight.value * displacement;
    rate_ += weight.value * velocity;
  }
  for (const NodeWeight& weight : second()) {
    stretch_ -= weight.value * Vector3(state[weight.node].displacement);
    rate_ -= weight.value * Vector3(state[weight.node].velocity);
  }
  frame_.a += rest.a;
  frame_.b += rest.b;
  rest.find_normal();
  frame_.find_normal();
  stretch_ += point.distance * (frame_.normal - rest.normal);
  rate_ += point.distance * across(rate_a.cross(frame_.b) + frame_.a.cross(rate_b)) / frame_.area;
}

Stretch::Variables Stretch::change_of_gradient(const Variables& change) const {
  const Vector3 a = change.segment<3>(3), b = change.tail<3>();
  const Vector3 &n = frame_.normal, &d = stretch_;
  const double h = point_.distance, difference = joint_.normal - joint_.tangential;
  // The changes of a x b, of its magnitude, of n, of d and of n.d
  const Vector3 turn = a.cross(frame_.b) + frame_.a.cross(b);
  const double growth = n.dot(turn);
  const Vector3 dn = across(turn) / frame_.area;
  const Vector3 dd = change.head<3>() + h * dn;
  const double along = n.dot(d), dalong = dn.dot(d) + n.dot(dd);
  // Those of what for_each_force() computes, for an area of 1
  const Vector3 force = stress_of(d);
  const Vector3 dforce = joint_.tangential * dd + difference * (dalong * n + along * dn);
  const Vector3 on_normal = h * force + difference * along * d;
  const Vector3 don_normal = h * dforce + difference * (dalong * d + along * dd);
  const Vector3 turning = across(on_normal) / frame_.area;
  const Vector3 dturning =
      (across(don_normal) - dn.dot(on_normal) * n - n.dot(on_normal) * dn - growth * turning) / frame_.area;
  Variables result;
  result << dforce, b.cross(turning) + frame_.b.cross(dturning), dturning.cross(frame_.a) + turning.cross(a);
  return point_.area * result;
}

Eigen::MatrixXd Stretch::stiffness() const {
  Eigen::Matrix<double, 9, 9> of_variables;
  for (Eigen::Index i = 0; i < 9; ++i) {
    of_variables.col(i) = change_of_gradient(Variables::Unit(i));
  }
  const Eigen::Index nodes = point_.end - point_.first_begin;
  Eigen::MatrixXd variables = Eigen::MatrixXd::Zero(9, 3 * nodes);  // of the displacements of the nodes
  for (Eigen::Index n = 0; n < nodes; ++n) {
    const NodeWeight& weight = joint_.weights[point_.first_begin + n];
    const bool is_first = point_.first_begin + n < point_.second_begin;
    const Vector3 factors(is_first ? weight.value : -weight.value, is_first ? weight.slope[0] : 0.0,
                          is_first ? weight.slope[1] : 0.0);
    for (Eigen::Index k = 0; k < 3; ++k) {
      variables.block<3, 3>(3 * k, 3 * n) = factors[k] * Eigen::Matrix3d::Identity();
    }
  }
  return variables.transpose() * ((of_variables + of_variables.transpose()) / 2) * variables;
}

}  // namespace idiophone::joints
