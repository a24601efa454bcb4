// What a modal body's motion is at one moment, as sums.

#include "modal_body.hpp"

namespace idiophone::modal_bodies {

void ModalBody::add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                         const Vector3& /*centre*/, const motion::BodyUnits& unit,
                         std::span<motion::BodySums> of_body) const {
  if (!is_here()) {
    return;
  }
  Load now;
  find_load(force, state, now);
  Step own = step;  // as if the next one were as long as the last
  own.length = own.before = before_;
  const FloatingFrame::Motion rigid =
      is_free_ ? frame_.now(own, now.force, now.torque, inertia_.change_of_moment(coordinates_.places()))
               : FloatingFrame::Motion{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  Vector3 displacement = inertia_.mass() * frame_.shift();
  Vector3 momentum = inertia_.mass() * rigid.velocity;
  Vector3 angular = inertia_.mass() * frame_.shift().cross(rigid.velocity) + rigid.angular_momentum;
  Eigen::Matrix3d deformed = Eigen::Matrix3d::Zero();  // sum m (R sum q phi) (X - C)^T
  const Eigen::ArrayXd& places = coordinates_.places();
  const Eigen::ArrayXd rates = coordinates_.rates_now(own, now.modal);
  for (std::size_t k = 0; k < modes_; ++k) {
    const auto mode = static_cast<Eigen::Index>(k);
    if (!is_free_) {
      displacement += places[mode] * inertia_.moments(k).momentum;
      momentum += rates[mode] * inertia_.moments(k).momentum;
      angular += rates[mode] * inertia_.moments(k).angular;
    }
    deformed += places[mode] * frame_.turn() * inertia_.moments(k).cross;
  }
  for (std::size_t node = 0; node < rest_.size(); ++node) {
    displacement += inertia_.masses()[node] * rest_[node];
    deformed += inertia_.masses()[node] * rest_[node] * inertia_.arms()[node].transpose();
  }
  const double kinetic = inertia_.mass() / 2 * rigid.velocity.squaredNorm() +
                         rigid.spin.dot(rigid.angular_momentum) / 2 + rates.square().sum() / 2 +
                         residual_.kinetic_energy();
  // What its stress at rest has done.
  const double of_rest = rest_.empty() ? 0.0 : ((rest_force_ + force_of_rest()) * places).sum() / 2;
  const double elastic = coordinates_.elastic_energy() + residual_.elastic_energy() - of_rest;
  const Eigen::Matrix3d turned = frame_.turn_less_one() * inertia_.second_moment();
  const Eigen::Matrix3d mixed = deformed * frame_.turn_less_one().transpose();
  const Vector3 shift = displacement / inertia_.mass();
  motion::BodySums& sums = of_body.front();
  const double area = unit.length * unit.length * unit.mass;
  motion::add(sums.displacement, displacement / (unit.mass * unit.length));
  motion::add(sums.momentum, momentum / unit.mass);
  motion::add(sums.angular_momentum, angular / (unit.mass * unit.length));
  motion::add(sums.cross_moment, Eigen::Matrix3d((turned + deformed) / area));
  // Of second order in the vibration is left out.
  const Eigen::Matrix3d second =
      is_free_ ? Eigen::Matrix3d(inertia_.mass() * shift * shift.transpose() +
                                 turned * frame_.turn_less_one().transpose() + mixed + mixed.transpose())
               : Eigen::Matrix3d(inertia_.mass() * shift * shift.transpose());
  motion::add(sums.second_moment, Eigen::Matrix3d(second / area));
  sums.kinetic.add(kinetic / unit.mass);
  sums.elastic.add(elastic / unit.mass);
}

}  // namespace idiophone::modal_bodies
