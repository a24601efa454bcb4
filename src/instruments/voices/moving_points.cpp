#include "idiophone/instruments/voices/moving_points.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::voices {

MovingPoints::MovingPoints(std::vector<HearingPoint> points)
    : from_(std::move(points)), to_({.start = 0, .length = 1, .points = from_}) {}

bool MovingPoints::begin_due(std::int64_t sample) {
  bool is_any = false;
  for (; !moves_.empty() && moves_.front().start <= sample; moves_.pop_front()) {
    for (std::size_t point = 0; point < from_.size(); ++point) {
      from_[point] = at(point, sample);
    }
    to_ = std::move(moves_.front());
    to_.start = sample;
    is_any = true;
  }
  return is_any;
}

std::int64_t MovingPoints::samples_without_change(std::int64_t sample, std::int64_t most) const {
  return moves_.empty() ? most : std::min(most, moves_.front().start - sample);
}

HearingPoint MovingPoints::at(std::size_t point, std::int64_t sample) const {
  const double share = std::clamp(static_cast<double>(sample - to_.start) / static_cast<double>(to_.length), 0.0, 1.0);
  HearingPoint found = to_.points[point];
  found.position = (1.0 - share) * from_[point].position + share * found.position;
  return found;
}

Hearing hearing(const HearingPoint& point, const Vector3& place, double nearest) {
  const Vector3 way = point.position - place;
  const double distance = std::max(way.norm(), nearest);
  const double sensitivity = 1.0 - point.directivity - point.directivity * way.dot(point.axis) / distance;
  return {.distance = distance, .gain = sensitivity / distance};
}

}  // namespace idiophone::voices
