#include "idiophone/timbre/nodes/curve.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::timbre {

Curve::Curve(std::vector<double> times, std::vector<double> values, Interpolation interpolation)
    : times_(std::move(times)), values_(std::move(values)), interpolation_(interpolation) {}

double Curve::at(double time) const {
  const auto next = std::ranges::upper_bound(times_, time);
  if (next == times_.begin()) {
    return values_.front();
  }
  if (next == times_.end()) {
    return values_.back();
  }
  const auto left = static_cast<std::size_t>(next - times_.begin() - 1);
  const double share = (time - times_[left]) / (times_[left + 1] - times_[left]);
  switch (interpolation_) {
    case Interpolation::hold:
      return values_[left];
    case Interpolation::cubic:
      return cubic(left, share);
    case Interpolation::linear:
      break;
  }
  return values_[left] + share * (values_[left + 1] - values_[left]);
}

double Curve::slope(std::size_t point) const {
  if (point == 0 || point + 1 == times_.size()) {
    return 0.0;
  }
  const double before = times_[point] - times_[point - 1];
  const double after = times_[point + 1] - times_[point];
  return ((values_[point] - values_[point - 1]) * after / before +
          (values_[point + 1] - values_[point]) * before / after) /
         (before + after);
}

double Curve::cubic(std::size_t left, double share) const {
  const double length = times_[left + 1] - times_[left];
  const double rest = 1.0 - share;
  return rest * rest * ((1.0 + 2.0 * share) * values_[left] + share * length * slope(left)) +
         share * share * ((1.0 + 2.0 * rest) * values_[left + 1] - rest * length * slope(left + 1));
}

}  // namespace idiophone::timbre
