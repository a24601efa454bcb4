#include "floating_frame.hpp"

#include <cmath>
#include <utility>

#include "idiophone/foundation/cross_matrix.hpp"
#include "idiophone/foundation/inertia_tensor.hpp"
#include "idiophone/solids/motion/kick.hpp"

namespace idiophone::modal_bodies {

namespace {

Eigen::Matrix3d inverse_inertia(const Eigen::Matrix3d& moment) {
  return inertia_tensor(moment).inverse();
}

/// The rotation by an angular velocity in some time.
Eigen::Quaterniond turned(const Vector3& spin, double time) {
  const Vector3 half = time / 2 * spin;
  const double square = half.squaredNorm();
  if (square > 1e-4) {
    const double angle = std::sqrt(square);
    const Vector3 vector = std::sin(angle) / angle * half;
    return {std::cos(angle), vector.x(), vector.y(), vector.z()};
  }
  // The series of cos(x) and sin(x)/x are exact to rounding, and much faster.
  const double cosine = 1 - square / 2 * (1 - square / 12 * (1 - square / 30));
  const Vector3 vector = (1 - square / 6 * (1 - square / 20 * (1 - square / 42))) * half;
  return {cosine, vector.x(), vector.y(), vector.z()};
}

}  // namespace

FloatingFrame::FloatingFrame(double mass, Eigen::Matrix3d moment, double damping, Vector3 gravity)
    : mass_(mass), moment_(std::move(moment)), damping_(damping), gravity_(std::move(gravity)) {}

void FloatingFrame::start(const Vector3& shift, const Eigen::Quaterniond& orientation, const Vector3& velocity,
                          const Vector3& spin) {
  shift_ = shift;
  orientation_ = orientation;
  velocity_ = velocity;
  spin_ = spin;
  orient();
  const Eigen::Matrix3d inertia = inertia_tensor(moment_);
  angular_momentum_ = turn_ * inertia * turn_.transpose() * spin;
}

void FloatingFrame::advance(const Step& step, const Vector3& force, const Vector3& torque,
                            const Eigen::Matrix3d& change) {
  const solid::Kick kick = motion::kick_of(step, damping_, gravity_);
  velocity_ = kick.keep * velocity_ + kick.gain * (force / mass_ + gravity_);
  shift_ += step.length * velocity_;
  angular_momentum_ = kick.keep * angular_momentum_ + kick.gain * torque;
  if (angular_momentum_.isZero(0.0)) {
    spin_.setZero();
    return;
  }
  // The midpoint rule: the angular velocity is that of half a step later. It is found by iteration, each of which gains
  // a factor of spin times dt.
  const Eigen::Matrix3d inverse = inverse_inertia(moment_ + change);
  const Vector3 momentum = turn_.transpose() * angular_momentum_;
  Vector3 spin = inverse * momentum;
  for (int i = 0; i < 3; ++i) {
    spin = inverse * (turned(spin, step.length / 2).conjugate() * momentum);
  }
  const Eigen::Quaterniond middle = orientation_ * turned(spin, step.length / 2);
  spin_ = middle * spin;
  orientation_ = (orientation_ * turned(spin, step.length)).normalized();
  orient();
}

FloatingFrame::Motion FloatingFrame::now(const Step& step, const Vector3& force, const Vector3& torque,
                                         const Eigen::Matrix3d& change) const {
  const double half = step.before / 2;
  Motion motion;
  motion.velocity = velocity_ + half * (force / mass_ + gravity_ - damping_ * velocity_);
  motion.angular_momentum = angular_momentum_ + half * (torque - damping_ * angular_momentum_);
  motion.spin = turn_ * inverse_inertia(moment_ + change) * turn_.transpose() * motion.angular_momentum;
  return motion;
}

void FloatingFrame::orient() {
  // R - 1 = 2 (w [v] + [v]^2) keeps small rotations; R itself would round them.
  const Vector3 v = orientation_.vec();
  const Eigen::Matrix3d cross = cross_matrix(v);
  less_one_ = 2 * (orientation_.w() * cross + cross * cross);
  turn_ = Eigen::Matrix3d::Identity() + less_one_;
}

void FloatingFrame::archive(parallel::ArchiveRow& row) {
  for (Vector3* vector : {&shift_, &velocity_, &angular_momentum_, &spin_}) {
    row.values(*vector);
  }
  row.values(orientation_.coeffs());
  orient();
}

}  // namespace idiophone::modal_bodies
