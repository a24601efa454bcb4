#pragma once
// A function of time through given values: keyframes, or the rows of a motion channel.

#include <cstddef>
#include <limits>
#include <vector>

namespace idiophone::timbre {

/// Between two values: a straight line, a smooth curve, or the first of them.
enum class Interpolation { linear, cubic, hold };

/// Before the first and after the last time, the value is constant.
class Curve {
 public:
  /// @param times   s, ascending, at least one
  /// @param values  one for each
  Curve(std::vector<double> times, std::vector<double> values, Interpolation interpolation);

  /// The value at a time (s). Linear between two times; constant from each time to the next (hold); or a cubic whose
  /// slope at each time is that of the parabola through it and its two neighbours.
  [[nodiscard]] double at(double time) const;

  /// The time from which the value is zero, s; infinite if the last value is not.
  [[nodiscard]] double silent_from() const {
    return values_.back() == 0.0 ? times_.back() : std::numeric_limits<double>::infinity();
  }

 private:
  [[nodiscard]] double slope(std::size_t point) const;
  [[nodiscard]] double cubic(std::size_t left, double share) const;

  std::vector<double> times_, values_;
  Interpolation interpolation_;
};

}  // namespace idiophone::timbre
