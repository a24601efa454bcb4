#include "ringing.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

namespace idiophone::waves {

std::vector<float> positions_of(const radiation::Solid& solid, const Vector3& shift) {
  std::vector<float> positions;
  for (const Vector3& vertex : solid.vertices) {
    const Vector3 place = vertex + shift;
    positions.insert(positions.end(), place.begin(), place.end());
  }
  return positions;
}

std::vector<float> shape_of(const radiation::Solid& solid, const NormalVelocity& velocity) {
  std::vector<float> shape;
  for (const auto& [a, b, c] : solid.corners()) {
    const Vector3 normal = (b - a).cross(c - a).normalized();
    double sum = 0.0;  // over the middles of the edges: the mean of a quadratic shape is exact
    for (const Vector3& place : {Vector3((a + b) / 2.0), Vector3((b + c) / 2.0), Vector3((c + a) / 2.0)}) {
      sum += velocity(place, normal);
    }
    shape.push_back(static_cast<float>(sum / 3.0));
  }
  return shape;
}

Responses ring(const Ringing& ringing, std::span<const double> frequencies, std::span<const Vector3> points) {
  const auto positions = positions_of(ringing.solid);
  const auto shape = shape_of(ringing.solid, ringing.shape);
  const PulseResponse sound({.obstruction = {ringing.solid.triangles, positions},
                             .shape = shape,
                             .cell = ringing.cell,
                             .speed = speed,
                             .impedance = impedance},
                            frequencies);
  Responses responses(frequencies.size());
  for (std::size_t f = 0; f < frequencies.size(); ++f) {
    for (const Vector3& point : points) {
      responses[f].push_back(sound.at(f, point));
    }
  }
  return responses;
}

double level(std::span<const Complex> one, std::span<const Complex> other) {
  const auto square = [](std::span<const Complex> values) {
    return std::accumulate(values.begin(), values.end(), 0.0, [](double sum, Complex v) { return sum + std::norm(v); });
  };
  return 10.0 * std::log10(square(one) / square(other));
}

}  // namespace idiophone::waves
