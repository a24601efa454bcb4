#include "moving_body.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/instruments/voices/voice.hpp"
#include "vectors.hpp"

namespace idiophone::engines {

namespace {

constexpr double silence = 11.5;          // nepers: 100 dB
constexpr double longest_sound = 3600.0;  // s

}  // namespace

MovingBody::MovingBody(const sound_maps::SoundMap& map, std::span<const Vector3> ears, int rate)
    : centre_(map.centre), farthest_(0.98 * voices::longest_way * map.air_speed), known_(ears.begin(), ears.end()) {
  double slowest = map.decay(0);
  for (std::size_t mode = 1; mode < map.modes(); ++mode) {
    slowest = std::min(slowest, map.decay(mode));
  }
  ringing_ = std::llround(std::min(longest_sound, silence / slowest) * rate);
}

void MovingBody::place(const Pose& pose) {
  const auto& [x, y, z, w] = pose.turn;
  to_body_ = (Eigen::Translation3d(vector_of(pose.position)) * Eigen::Quaterniond(w, x, y, z).normalized()).inverse();
}

resonators::PointForce MovingBody::in_body(const resonators::PointForce& force) const {
  resonators::PointForce turned = force;
  turned.at = to_body_ * force.at;
  turned.direction = to_body_.linear() * force.direction;
  return turned;
}

void MovingBody::sound_until(std::int64_t sample) {
  silent_from_ = std::max(silent_from_, sample + ringing_);
}

/// Ears that are too far away to be played are as far as is possible.
std::vector<voices::HearingPoint> MovingBody::points(std::span<const Vector3> ears) const {
  std::vector<voices::HearingPoint> points;
  for (const Vector3& ear : ears) {
    const Vector3 way = to_body_ * ear - centre_;
    points.push_back({.position = centre_ + way * std::min(1.0, farthest_ / std::max(farthest_, way.norm()))});
  }
  return points;
}

std::optional<voices::ListenerPlace> MovingBody::follow(std::span<const Vector3> ears, std::int64_t start,
                                                        std::int64_t length, bool begins) {
  const bool sounds = start < silent_from_;
  if (!sounds && !begins) {
    return {};
  }
  voices::ListenerPlace place{.start = start, .length = sounds ? length : 1, .points = points(ears)};
  if (std::ranges::equal(place.points, known_, {}, &voices::HearingPoint::position)) {
    return {};
  }
  std::ranges::transform(place.points, known_.begin(), &voices::HearingPoint::position);
  return place;
}

}  // namespace idiophone::engines
