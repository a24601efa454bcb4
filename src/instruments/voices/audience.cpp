#include "idiophone/instruments/voices/audience.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace idiophone::voices {

std::size_t Audience::receivers() const {
  return std::max<std::size_t>(1, listener_ ? listener_->receivers.size() : fixed_.size());
}

std::vector<HearingPoint> Audience::points(double time) const {
  if (!listener_) {
    return fixed_;
  }
  std::vector<HearingPoint> points;
  for (std::size_t r = 0; r < (has_head() ? 1 : receivers()); ++r) {
    const scene::Receiver& receiver = listener_->receivers[r];
    const Vector3 position = listener_->place(receiver, time).position + shift_;
    points.push_back({.position = position, .axis = receiver.axis, .directivity = receiver.directivity});
  }
  return points;
}

Vector3 Audience::look() const {
  if (!listener_ || (listener_->receivers.size() == 1 && listener_->receivers.front().directivity == 0.0)) {
    return Vector3::Zero();
  }
  Vector3 sum = Vector3::Zero();
  for (const scene::Receiver& receiver : listener_->receivers) {
    sum += receiver.axis;
  }
  return sum.norm() > 1e-6 ? Vector3(sum.normalized()) : Vector3::Zero();
}

Vector3 Audience::shift_to(const Vector3& position) const {
  Vector3 middle = Vector3::Zero();
  for (const scene::Receiver& receiver : listener_->receivers) {
    middle += receiver.position / static_cast<double>(receivers());
  }
  return position - middle;
}

void Audience::move_to(const Vector3& position) {
  shift_ = shift_to(position);
}

double Audience::way_to(const Vector3& position) const {
  return (shift_to(position) - shift_).norm();
}

std::vector<double> Audience::head_responses(const Vector3& place, const HearingPoint& point) const {
  const auto& [look, up, responses, where] = *listener_->head;
  const Vector3 way = place - point.position;
  const Vector3 in_head(look.dot(way), up.cross(look).dot(way), up.dot(way));
  return head_(in_head);
}

Vector3 middle_of(std::span<const HearingPoint> points) {
  Vector3 sum = Vector3::Zero();
  for (const HearingPoint& point : points) {
    sum += point.position;
  }
  return sum / static_cast<double>(points.size());
}

}  // namespace idiophone::voices
