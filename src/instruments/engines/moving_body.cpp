#include "moving_body.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/instruments/touching/vectors.hpp"
#include "idiophone/instruments/voices/voice.hpp"

namespace idiophone::engines {

using touching::vector_of;

namespace {

constexpr double silence = 11.5;            // nepers: 100 dB
constexpr double longest_sound = 3600.0;    // s
constexpr double nearest = 0.01;            // m, of an ear
constexpr double unheard_tolerance = 0.01;  // of the distance of an ear

}  // namespace

MovingBody::MovingBody(const sound_maps::SoundMap& map, double loudness, std::span<const Vector3> ears, int rate)
    : centre_(map.centre),
      loudness_(loudness),
      farthest_(0.98 * voices::longest_way * map.air_speed),
      slowest_(map.decay(0)),
      rate_(rate),
      known_(ears.begin(), ears.end()) {
  for (std::size_t mode = 1; mode < map.modes(); ++mode) {
    slowest_ = std::min(slowest_, map.decay(mode));
  }
  tune({}, 0);
}

/// Friction multiplies a part of the decay, and the size divides all of it.
void MovingBody::tune(const score::Tuning& tuning, std::int64_t sample) {
  const double slowest = std::min(1.0, tuning.friction) * slowest_ / tuning.size;
  ringing_ = std::llround(std::min(longest_sound, silence / slowest) * rate_);
  if (sample < silent_from_) {
    sound_until(sample);
  }
}

void MovingBody::place(const Pose& pose) {
  const auto& [x, y, z, w] = pose.turn;
  to_body_ = (Eigen::Translation3d(vector_of(pose.position)) * Eigen::Quaterniond(w, x, y, z).normalized()).inverse();
}

resonators::PointForce in_body(const Eigen::Isometry3d& to_body, const resonators::PointForce& force) {
  resonators::PointForce turned = force;
  turned.at = to_body * force.at;
  turned.direction = to_body.linear() * force.direction;
  return turned;
}

double MovingBody::loudness(double impulse, std::span<const Vector3> ears) const {
  double distance = farthest_;
  for (const Vector3& ear : ears) {
    distance = std::min(distance, (to_body_ * ear - centre_).norm());
  }
  return impulse * loudness_ / std::max(distance, nearest);
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

bool MovingBody::is_near(const voices::HearingPoint& point, const Vector3& known, double tolerance) const {
  return (point.position - known).norm() <= tolerance * (known - centre_).norm();
}

std::optional<voices::ListenerPlace> MovingBody::follow(std::span<const Vector3> ears, std::int64_t start,
                                                        std::int64_t length, Part part) {
  const bool sounds = start < silent_from_;
  if (!sounds && part != Part::struck) {
    return {};
  }
  voices::ListenerPlace place{.start = start, .length = sounds ? length : 1, .points = points(ears)};
  const double tolerance = part == Part::unheard ? unheard_tolerance : 0.0;
  if (std::ranges::equal(place.points, known_, [&](const voices::HearingPoint& point, const Vector3& known) {
        return is_near(point, known, tolerance);
      })) {
    return {};
  }
  std::ranges::transform(place.points, known_.begin(), &voices::HearingPoint::position);
  return place;
}

}  // namespace idiophone::engines
