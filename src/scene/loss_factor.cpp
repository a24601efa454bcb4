#include "idiophone/scene/loss_factor.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace idiophone::scene {

double LossFactor::at(double frequency) const {
  if (curve.empty()) {
    return value;
  }
  const auto next = std::ranges::upper_bound(curve, frequency, {}, &Point::frequency);
  if (next == curve.begin() || next == curve.end()) {
    return (next == curve.begin() ? curve.front() : curve.back()).value;
  }
  const Point& before = *std::prev(next);
  const double part = std::log(frequency / before.frequency) / std::log(next->frequency / before.frequency);
  return before.value * std::pow(next->value / before.value, part);
}

}  // namespace idiophone::scene
