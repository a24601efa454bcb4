#pragma once
// Numbers that change over time, as decks and scores give them point by point.

#include <vector>

namespace idiophone::scene {

/// A number that changes over time: linear between its points, constant before and after them.
struct Course {
  struct Point {
    double time = 0.0;  ///< s
    double value = 0.0;
  };
  std::vector<Point> points;  ///< at least one, in the order of their times

  /// Realtime-safe.
  [[nodiscard]] double at(double time) const;
  [[nodiscard]] double largest() const;
  [[nodiscard]] double last() const { return points.back().value; }
  /// All values become so many times as large.
  void scale(double factor);
};

}  // namespace idiophone::scene
