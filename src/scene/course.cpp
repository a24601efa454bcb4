#include "idiophone/scene/course.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace idiophone::scene {

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

}  // namespace idiophone::scene
