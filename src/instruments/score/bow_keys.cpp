// Bows, and numbers that change over time.

#include <algorithm>
#include <cmath>
#include <functional>

#include "actions.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::score {

using namespace deck;  // values, keys and sections

namespace {

/// A number, or a list of points [time, number].
struct CourseRule {
  Range range;
};

bool read(const Node& node, Mistakes& mistakes, Course::Point& point, const CourseRule& rule) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected [time, value], found " + describe(node));
  }
  const Range seconds{.at_least = 0.0, .at_most = longest_force, .unit = "s"};
  return read(node.children[0], mistakes, point.time, seconds) &&
         read(node.children[1], mistakes, point.value, rule.range);
}

bool read(const Node& node, Mistakes& mistakes, Course& course, const CourseRule& rule) {
  if (node.kind != Node::Kind::list) {
    return read(node, mistakes, course.points.emplace_back().value, rule.range);
  }
  if (node.children.empty()) {
    return mistakes.add(node, "the list is empty; give a number, or points [time, value]");
  }
  if (!read(node, mistakes, course.points, rule)) {
    return false;
  }
  if (std::ranges::adjacent_find(course.points, std::greater_equal(), &Course::Point::time) != course.points.end()) {
    return mistakes.add(node, "the times of the points must ascend");
  }
  return true;
}

struct FrictionKeys {};

bool read(const Node& node, Mistakes& mistakes, Friction& friction, const FrictionKeys& /*rule*/) {
  constexpr Range coefficient{.above = 0.0, .at_most = 10.0};
  constexpr Range per_speed{.at_least = 0.0, .at_most = 1e6, .unit = "N s/m"};
  Section section(node, mistakes);
  const bool has_sticking = section.optional("sticking", friction.sticking, coefficient);
  if (section.optional("sliding", friction.sliding, coefficient) && has_sticking &&
      friction.sliding > friction.sticking) {
    mistakes.add(node, fmt::format("the coefficient of sliding, {}, is above that of sticking, {}", friction.sliding,
                                   friction.sticking));
  }
  section.optional("stribeck_speed", friction.stribeck_speed, Range{.at_least = 1e-6, .at_most = 1e3, .unit = "m/s"});
  section.optional("stiffness", friction.stiffness, Range{.at_least = 1.0, .at_most = 1e12, .unit = "N/m"});
  section.optional("damping", friction.damping, per_speed);
  section.optional("viscosity", friction.viscosity, per_speed);
  section.optional("break_away", friction.break_away, Range{.at_least = 0.0, .at_most = 0.99});
  return section.finish();
}

}  // namespace

double Course::at(double time) const {
  const auto next = std::ranges::upper_bound(points, time, {}, &Point::time);
  if (next == points.begin() || next == points.end()) {
    return (next == points.begin() ? points.front() : points.back()).value;
  }
  const Point& before = *std::prev(next);
  return std::lerp(before.value, next->value, (time - before.time) / (next->time - before.time));
}

double Course::largest() const {
  return std::ranges::max_element(points, {}, &Point::value)->value;
}

void Course::scale(double factor) {
  for (Point& point : points) {
    point.value *= factor;
  }
}

void read_bow(Section& section, Bow& bow) {
  section.required("at", bow.at, scene::coordinate);
  section.required("direction", bow.direction, scene::unit_vector);
  section.required("speed", bow.speed, CourseRule{{.at_least = -1e3, .at_most = 1e3, .unit = "m/s"}});
  section.required("load", bow.load, CourseRule{{.at_least = 0.0, .at_most = 1e6, .unit = "N"}});
  section.optional("friction", bow.friction, FrictionKeys{});
}

}  // namespace idiophone::score
