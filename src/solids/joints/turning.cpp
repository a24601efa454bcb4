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

Eigen::MatrixXd Turning::stiffness() const {
  const Eigen::Index nodes = point_.end - point_.first_begin, of_first = point_.second_begin - point_.first_begin;
  Eigen::VectorXd gradient(3 * nodes), slopes(nodes);
  Eigen::Index row = 0;
  for_each_gradient([&](Index /*node*/, const Vector3& at_node) {
    gradient.segment<3>(3 * row) = at_node;
    slopes[row] = joint_.weights[point_.first_begin + row].slope[0];
    ++row;
  });
  Eigen::MatrixXd stiffness = joint_.normal * gradient * gradient.transpose();
  // s is bilinear in the nodes of the two bodies.
  const Eigen::MatrixXd mixed =
      joint_.normal * sine_ * slopes.head(of_first) * slopes.tail(nodes - of_first).transpose();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto first = Eigen::seqN(i, of_first, 3), second = Eigen::seqN(3 * of_first + i, nodes - of_first, 3);
    stiffness(first, second) += mixed;
    stiffness(second, first) += mixed.transpose();
  }
  return stiffness;
}

}  // namespace idiophone::joints
