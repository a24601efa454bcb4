#include "joint_stretch.hpp"

namespace idiophone::joints {

namespace {

/// The matrix of v x.
Eigen::Matrix3d cross_matrix(const Vector3& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return matrix;
}

}  // namespace

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

Eigen::MatrixXd undeformed_stiffness(const MeshedJoint& joint, const JointPoint& point,
                                     std::span<const Vector3> reference) {
  const SurfaceFrame frame = undeformed_frame(joint, point, reference);
  const Eigen::Matrix3d along = frame.normal * frame.normal.transpose();
  const Eigen::Matrix3d turn = point.distance / frame.area * (Eigen::Matrix3d::Identity() - along);
  Eigen::MatrixXd stretch(3, 3 * (point.end - point.first_begin));  // of displacements of the nodes
  Eigen::Index column = 0;
  for (Index place = point.first_begin; place < point.end; ++place, column += 3) {
    const NodeWeight& weight = joint.weights[place];
    const double side = place < point.second_begin ? 1.0 : -1.0;
    stretch.middleCols<3>(column) =
        side * weight.value * Eigen::Matrix3d::Identity() +
        turn * (weight.slope[1] * cross_matrix(frame.a) - weight.slope[0] * cross_matrix(frame.b));
  }
  const Eigen::Matrix3d stiffness =
      point.area * (joint.tangential * (Eigen::Matrix3d::Identity() - along) + joint.normal * along);
  return stretch.transpose() * stiffness * stretch;
}

}  // namespace idiophone::joints
