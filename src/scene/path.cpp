// Where a listener goes. No decks: the library for engines has this file, too.

#include <algorithm>

#include "idiophone/scene/listeners.hpp"

namespace idiophone::scene {

namespace {

/// From one point of a path to the next.
struct Stretch {
  double duration;           // s
  Vector3 mean;              // velocity, m/s
  Vector3 at_begin, at_end;  // velocities, m/s
};

Vector3 mean_velocity(const Path::Point& from, const Path::Point& to) {
  return (to.position - from.position) / (to.time - from.time);
}

/// At points[i]: the slope of the parabola through it and its neighbours; at an end, the mean over the only stretch.
Vector3 velocity_at(const std::vector<Path::Point>& points, std::size_t i) {
  if (i == 0) {
    return mean_velocity(points[0], points[1]);
  }
  Vector3 before = mean_velocity(points[i - 1], points[i]);
  if (i + 1 == points.size()) {
    return before;
  }
  const Vector3 after = mean_velocity(points[i], points[i + 1]);
  const double part = (points[i].time - points[i - 1].time) / (points[i + 1].time - points[i - 1].time);
  return (1.0 - part) * before + part * after;
}

/// From points[i] to points[i + 1].
Stretch stretch(const std::vector<Path::Point>& points, std::size_t i) {
  return {points[i + 1].time - points[i].time, mean_velocity(points[i], points[i + 1]), velocity_at(points, i),
          velocity_at(points, i + 1)};
}

}  // namespace

Place Path::at(double time) const {
  const Point& first = points.front();
  const Point& last = points.back();
  if (time <= first.time || time >= last.time) {
    const Point& end = time <= first.time ? first : last;
    const Vector3 velocity = velocity_at(points, time <= first.time ? 0 : points.size() - 1);
    return {end.position + (time - end.time) * velocity, velocity};
  }
  const auto next = std::ranges::upper_bound(points, time, {}, &Point::time);
  const auto i = static_cast<std::size_t>(next - points.begin()) - 1;
  const auto [duration, mean, at_begin, at_end] = stretch(points, i);
  // Newton's form of Hermite's cubic: from the steady motion, and what bends it.
  const double t = time - points[i].time;
  const Vector3 bend = (mean - at_begin) / duration;
  const Vector3 twist = (at_begin + at_end - 2.0 * mean) / (duration * duration);
  const double rest = t - duration;
  return {points[i].position + t * (at_begin + t * (bend + rest * twist)),
          at_begin + t * (2.0 * bend + (t + 2.0 * rest) * twist)};
}

double Path::fastest() const {
  // Over a stretch the velocity is a parabola, inside of the triangle of its Bezier points.
  double fastest = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto [duration, mean, at_begin, at_end] = stretch(points, i);
    fastest = std::max({fastest, at_begin.norm(), at_end.norm(), (3.0 * mean - at_begin - at_end).norm()});
  }
  return fastest;
}

Place Listener::place(const Receiver& receiver, double time) const {
  if (!path) {
    return {.position = receiver.position};
  }
  const Place now = path->at(time);
  return {receiver.position + (now.position - path->at(0.0).position), now.velocity};
}

}  // namespace idiophone::scene
