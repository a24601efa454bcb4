#include "blow_directions.hpp"

#include <algorithm>

namespace idiophone::measured_maps {

namespace {

std::size_t nearest_of(std::span<const Vector3> places, const Vector3& place) {
  const auto distance = [&](const Vector3& other) { return (other - place).squaredNorm(); };
  return static_cast<std::size_t>(std::ranges::min_element(places, {}, distance) - places.begin());
}

}  // namespace

BlowDirections::BlowDirections(std::span<const RecordedBlow> blows) {
  constexpr double opposite = -0.5;  // cosine
  for (const RecordedBlow& blow : blows) {
    const bool is_opposite =
        !places_.empty() && directions_[nearest_of(places_, blow.at)].dot(blow.direction) < opposite;
    sign_.push_back(is_opposite ? -1.0 : 1.0);
    places_.push_back(blow.at);
    directions_.emplace_back(sign_.back() * blow.direction);
  }
}

std::vector<Vector3> BlowDirections::at(std::span<const Vector3> places) const {
  constexpr double least_mean = 0.1, smallest = 1e-18;  // m2, so that a weight is finite
  std::vector<Vector3> found;
  for (const Vector3& place : places) {
    Vector3 sum = Vector3::Zero();
    double total = 0.0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const double weight = 1.0 / ((places_[k] - place).squaredNorm() + smallest);
      sum += weight * directions_[k];
      total += weight;
    }
    found.push_back(sum.norm() > least_mean * total ? sum.normalized() : directions_[nearest_of(places_, place)]);
  }
  return found;
}

void BlowDirections::turn(std::vector<double>& strength) const {
  std::ranges::transform(strength, sign_, strength.begin(), std::multiplies());
}

}  // namespace idiophone::measured_maps
