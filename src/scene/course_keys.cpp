#include "idiophone/scene/course_keys.hpp"

#include <algorithm>
#include <functional>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

/// [time, number]
struct PointRule {
  CourseRule of;
};

bool read(const Node& node, Mistakes& mistakes, Course::Point& point, const PointRule& rule) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected [time, value], found " + describe(node));
  }
  const Range seconds{.at_least = 0.0, .at_most = rule.of.longest, .unit = "s"};
  return deck::read(node.children[0], mistakes, point.time, seconds) &&
         deck::read(node.children[1], mistakes, point.value, rule.of.range);
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Course& course, const CourseRule& rule) {
  if (node.kind != Node::Kind::list) {
    return deck::read(node, mistakes, course.points.emplace_back().value, rule.range);
  }
  if (node.children.empty()) {
    return mistakes.add(node, "the list is empty; give a number, or points [time, value]");
  }
  if (!deck::read(node, mistakes, course.points, PointRule{rule})) {
    return false;
  }
  if (std::ranges::adjacent_find(course.points, std::greater_equal(), &Course::Point::time) != course.points.end()) {
    return mistakes.add(node, "the times of the points must ascend");
  }
  return true;
}

}  // namespace idiophone::scene
