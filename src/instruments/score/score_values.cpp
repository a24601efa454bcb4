// What the numbers of an action mean. No decks: the library for engines has this file, too.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/instruments/score/action.hpp"

namespace idiophone::score {

double Hammer::contact_duration() const {
  static const double factor = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);  // 2.9433
  return factor * std::pow(1.25 * mass * speed * speed / hardness, 0.4) / speed;
}

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

}  // namespace idiophone::score
