// What a modal body's motion is at one moment, as sums.

#include "modal_body.hpp"

namespace idiophone::modal_bodies {

ModalBody::RestMoments ModalBody::find_rest_moments() const {
  RestMoments moments;
  for (std::size_t node = 0; node < rest_.size(); ++node) {
    const Vector3 apart = rest_[node] - mean_rest_;
    const Vector3 weighted = inertia_.masses()[node] * apart;
    moments.with_arms += weighted * inertia_.arms()[node].transpose();
    moments.square += weighted * apart.transpose();
  }
  return moments;
}

double ModalBody::energy_of_rest() const {
  const Eigen::VectorXd places = coordinates().places().matrix();
  return rest_.empty() ? 0.0 : places.dot(rest_stiffness_ * places) / 2 - places.dot(rest_force_.matrix());
}

double ModalBody::kinetic_energy(const Eigen::ArrayXd& rates) const {
  return share_of_mass_.size() == 0 ? rates.square().sum() / 2
                                    : rates.matrix().dot(share_of_mass_ * rates.matrix()) / 2;
}

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
      is_free_ ? frame_.now(own, now.force, now.torque, inertia_.change_of_moment(coordinates().places()))
               : FloatingFrame::Motion{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  Vector3 displacement = inertia_.mass() * (frame_.shift() + mean_rest_);
  Vector3 momentum = inertia_.mass() * rigid.velocity;
  Vector3 angular = inertia_.mass() * frame_.shift().cross(rigid.velocity) + rigid.angular_momentum;
  Eigen::Matrix3d deformed = rest_moments_.with_arms;  // sum m (r + R sum q phi) a^T, a the arms at rest
  const Eigen::ArrayXd& places = coordinates().places();
  add_loads_of_others(force, state, now.modal);
  const Eigen::ArrayXd rates = coordinates().rates_now(own, now.modal);
  for (std::size_t k = 0; k < modes_; ++k) {
    const auto mode = static_cast<Eigen::Index>(k);
    if (!is_free_) {
      displacement += places[mode] * inertia_.moments(k).momentum;
      momentum += rates[mode] * inertia_.moments(k).momentum;
      angular += rates[mode] * inertia_.moments(k).angular;
    }
    deformed += places[mode] * frame_.turn() * inertia_.moments(k).cross;
  }
  angular += mean_rest_.cross(momentum);  // frame and arms count from the centre of mass at rest
  const double kinetic = inertia_.mass() / 2 * rigid.velocity.squaredNorm() +
                         rigid.spin.dot(rigid.angular_momentum) / 2 + kinetic_energy(rates) +
                         residual_.kinetic_energy();
  // Common modes store their energy in all bodies and in the joints between them: it counts as that of the first body.
  const double elastic =
      (is_first() ? coordinates().elastic_energy() : 0.0) + residual_.elastic_energy() + energy_of_rest();
  const Eigen::Matrix3d turned = frame_.turn_less_one() * inertia_.second_moment();
  const Eigen::Matrix3d mixed = deformed * frame_.turn_less_one().transpose();
  const Vector3 shift = displacement / inertia_.mass();
  motion::BodySums& sums = of_body.front();
  const double area = unit.length * unit.length * unit.mass;
  motion::add(sums.displacement, displacement / (unit.mass * unit.length));
  motion::add(sums.momentum, momentum / unit.mass);
  motion::add(sums.angular_momentum, angular / (unit.mass * unit.length));
  // With X - C = a - r. What is of second order in the vibration is left out, and its products with r.
  const Eigen::Matrix3d of_arms = rest_moments_.square + frame_.turn_less_one() * rest_moments_.with_arms.transpose();
  motion::add(sums.cross_moment, Eigen::Matrix3d((turned + deformed - of_arms) / area));
  Eigen::Matrix3d second = inertia_.mass() * shift * shift.transpose() + rest_moments_.square;
  if (is_free_) {
    second += turned * frame_.turn_less_one().transpose() + mixed + mixed.transpose();
  }
  motion::add(sums.second_moment, Eigen::Matrix3d(second / area));
  sums.kinetic.add(kinetic / unit.mass);
  sums.elastic.add(elastic / unit.mass);
}

}  // namespace idiophone::modal_bodies
