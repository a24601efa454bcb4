#include "idiophone/instruments/voices/falling_piece.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "idiophone/foundation/inertia_tensor.hpp"

namespace idiophone::voices {

namespace {

constexpr double flight_step = 2.5e-4;  // s
constexpr double slow_impact = 0.05;    // m/s: impacts up to here do not rebound and make no sound
constexpr int most_impacts_in_a_step = 20;
constexpr std::size_t most_kept_states = 400;  // states: 0.1 s

}  // namespace

FallingPiece::FallingPiece(RigidPiece piece, const RigidState& begin, double time, Ground ground)
    : piece_(std::move(piece)), ground_(std::move(ground)), begin_(time), states_{begin} {
  inverse_inertia_ = inertia_tensor(piece_.second).inverse();
  for (const Vector3& point : piece_.points) {
    radius_ = std::max(radius_, (point - piece_.centre).norm());
  }
}

std::vector<Landing> FallingPiece::advance(double time) {
  std::vector<Landing> landings;
  while (!rests_ && time_of_next() <= time) {
    RigidState next = moved(states_.back(), flight_step);
    bool touches = false;
    for (int impact = 0; impact < most_impacts_in_a_step; ++impact) {
      const Approach approach = fastest_approach(next);
      if (approach.speed <= 0.0) {
        break;
      }
      touches = true;
      Landing landing = land(next, approach);
      landing.time = time_of_next();
      if (landing.speed > slow_impact) {
        landings.push_back(landing);
      }
    }
    rests_ = touches && is_slow(next);
    if (rests_) {
      next.velocity.setZero();
      next.angular_momentum.setZero();
    }
    states_.push_back(next);
    if (states_.size() > most_kept_states) {
      states_.pop_front();
      ++dropped_;
    }
  }
  return landings;
}

double FallingPiece::time_of_next() const {
  return begin_ + static_cast<double>(dropped_ + std::ssize(states_)) * flight_step;
}

RigidState FallingPiece::at(double time) const {
  const double steps = std::max(0.0, (time - begin_) / flight_step - static_cast<double>(dropped_));
  const auto last = static_cast<std::size_t>(std::min(steps, static_cast<double>(states_.size() - 1)));
  const bool at_rest = rests_ && last + 1 == states_.size();
  return at_rest ? states_.back() : moved(states_[last], (steps - static_cast<double>(last)) * flight_step);
}

Eigen::Isometry3d FallingPiece::pose(double time) const {
  const RigidState now = at(time);
  return Eigen::Translation3d(now.centre) * now.turn * Eigen::Translation3d(-piece_.centre);
}

double FallingPiece::energy(const RigidState& state) const {
  return piece_.mass * (0.5 * state.velocity.squaredNorm() - ground_.gravity.dot(state.centre)) +
         0.5 * spin(state).dot(state.angular_momentum);
}

Vector3 FallingPiece::spin(const RigidState& state) const {
  return state.turn * (inverse_inertia_ * (state.turn.conjugate() * state.angular_momentum));
}

Vector3 FallingPiece::arm(const RigidState& state, std::size_t point) const {
  return state.turn * (piece_.points[point] - piece_.centre);
}

Vector3 FallingPiece::velocity_of(const RigidState& state, const Vector3& arm) const {
  return state.velocity + spin(state).cross(arm);
}

double FallingPiece::mobility(const RigidState& state, const Vector3& arm, const Vector3& direction) const {
  const Vector3 torque = arm.cross(direction);
  const Vector3 turned = state.turn * (inverse_inertia_ * (state.turn.conjugate() * torque));
  return 1.0 / piece_.mass + torque.dot(turned);
}

void FallingPiece::push(RigidState& state, double mass, const Vector3& arm, const Vector3& impulse) {
  state.velocity += impulse / mass;
  state.angular_momentum += arm.cross(impulse);
}

RigidState FallingPiece::moved(const RigidState& state, double duration) const {
  const auto turned = [&](const Vector3& spin, double time) {
    const Vector3 turn = time * spin;
    return (Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * state.turn).normalized();
  };
  RigidState middle = state, next = state;
  middle.turn = turned(spin(state), duration / 2);
  next.turn = turned(spin(middle), duration);
  next.centre += duration * state.velocity + 0.5 * duration * duration * ground_.gravity;
  next.velocity += duration * ground_.gravity;
  return next;
}

FallingPiece::Approach FallingPiece::fastest_approach(const RigidState& state) const {
  Approach fastest{.normal = Vector3::Zero(), .point = 0};
  for (const Floor& floor : ground_.floors) {
    if ((state.centre - floor.at).dot(floor.normal) > radius_) {
      continue;
    }
    for (std::size_t point = 0; point < piece_.points.size(); ++point) {
      const Vector3 arm = this->arm(state, point);
      const double speed = -velocity_of(state, arm).dot(floor.normal);
      if ((state.centre + arm - floor.at).dot(floor.normal) < 0.0 && speed > fastest.speed) {
        fastest = {.normal = floor.normal, .point = point, .speed = speed};
      }
    }
  }
  return fastest;
}

Landing FallingPiece::land(RigidState& state, const Approach& approach) const {
  const Vector3 arm = this->arm(state, approach.point);
  const double mass = 1.0 / mobility(state, arm, approach.normal);
  const double rebound = approach.speed > slow_impact ? ground_.restitution : 0.0;
  const Vector3 normal = (1.0 + rebound) * mass * approach.speed * approach.normal;
  push(state, piece_.mass, arm, normal);
  Vector3 friction = Vector3::Zero();
  const Vector3 velocity = velocity_of(state, arm);
  const Vector3 slip = velocity - velocity.dot(approach.normal) * approach.normal;
  if (slip.norm() > 0.0) {
    const double stopping = slip.norm() / mobility(state, arm, slip.normalized());
    friction = -std::min(stopping, ground_.friction * normal.norm()) * slip.normalized();
    push(state, piece_.mass, arm, friction);
  }
  return {.at = piece_.points[approach.point],
          .impulse = state.turn.conjugate() * (normal + friction),
          .speed = approach.speed,
          .mass = mass};
}

bool FallingPiece::is_slow(const RigidState& state) const {
  return state.velocity.norm() + spin(state).norm() * radius_ < slow_impact;
}

}  // namespace idiophone::voices
