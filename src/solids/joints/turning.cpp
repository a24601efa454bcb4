#include "turning.hpp"

namespace idiophone::joints {

Turning::Turning(const MeshedJoint& joint, const JointPoint& point, std::span<const Vector3> reference,
                 std::span<const solid::NodeState> state)
    : joint_(joint), point_(point) {
  std::array<Vector3, 2> rate = {Vector3::Zero(), Vector3::Zero()};  // of the directions, 1/s
  for (Index place = point.first_begin; place < point.end; ++place) {
    const NodeWeight& weight = joint.weights[place];
    const std::size_t body = place < point.second_begin ? 0 : 1;
    direction_[body] += weight.slope[0] * (reference[weight.node] + Vector3(state[weight.node].displacement));
    rate[body] += weight.slope[0] * Vector3(state[weight.node].velocity);
  }
  sine_ = direction_[0].dot(direction_[1]);
  rate_ = rate[0].dot(direction_[1]) + direction_[0].dot(rate[1]);
}

Eigen::MatrixXd stiffness_against_turning(const MeshedJoint& joint, const JointPoint& point,
                                          std::span<const Vector3> reference) {
  const std::vector<solid::NodeState> at_rest(reference.size());
  Eigen::VectorXd gradient(3 * (point.end - point.first_begin));
  Eigen::Index row = 0;
  Turning(joint, point, reference, at_rest).for_each_gradient([&](Index /*node*/, const Vector3& at_node) {
    gradient.segment<3>(row) = at_node;
    row += 3;
  });
  return joint.normal * gradient * gradient.transpose();
}

}  // namespace idiophone::joints
