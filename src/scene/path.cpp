// Where a listener goes.

#include <algorithm>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

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

namespace {

/// A row [time, x, y, z] of the deck.
bool read_row(const Node& node, Mistakes& mistakes, CsvRows& rows) {
  if (node.kind != Node::Kind::list || node.children.size() != 4) {
    return mistakes.add(node, "expected a row [time, x, y, z] (s and m), found " + describe(node));
  }
  std::vector<double> row(4);
  bool good = read(node.children[0], mistakes, row[0], Range{.at_least = 0.0, .at_most = 1e6, .unit = "s"});
  for (std::size_t i = 1; i < row.size(); ++i) {
    good &= read(node.children[i], mistakes, row[i], coordinate);
  }
  if (good && !rows.empty() && row[0] <= rows.back()[0]) {
    good = mistakes.add(node, fmt::format("times must ascend; {} s does not follow {} s", row[0], rows.back()[0]));
  }
  rows.push_back(row);
  return good;
}

bool read_rows(const Node& node, Mistakes& mistakes, CsvRows& rows) {
  bool good = true;
  for (const Node& child : node.children) {
    good &= read_row(child, mistakes, rows);
  }
  if (good && rows.size() < 2) {
    return mistakes.add(node, fmt::format("needs at least 2 rows [time, x, y, z], found {}", rows.size()));
  }
  return good;
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Path& path, const Folder& folder) {
  CsvRows rows;
  const bool good = node.kind == Node::Kind::list
                        ? read_rows(node, mistakes, rows)
                        : read(node, mistakes, rows, folder, CsvColumns{{"time", "x", "y", "z"}});
  if (!good) {
    return false;
  }
  path.where = node.where;
  for (const auto& row : rows) {
    path.points.push_back({row[0], {row[1], row[2], row[3]}});
    if (!(path.points.back().position.cwiseAbs().maxCoeff() <= coordinate.at_most)) {
      return mistakes.add(node, fmt::format("at {} s the position ({}, {}, {}) m is farther than {} m from the origin",
                                            row[0], row[1], row[2], row[3], coordinate.at_most));
    }
  }
  return true;
}

}  // namespace idiophone::scene
