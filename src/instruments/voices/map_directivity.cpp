#include "map_directivity.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numbers>
#include <utility>

namespace idiophone::voices {

namespace {

/// Both parts of a complex number, which are computed at once.
using RealAndImaginary = double __attribute__((vector_size(2 * sizeof(double))));

}  // namespace

/// Degree by degree for all directions, so that the processor computes several directions at once.
std::vector<double> weights_in_direction(const sound_maps::MapSphere& sphere, const Vector3& direction) {
  const std::size_t directions = sphere.direction.size();
  std::vector<double> cosine, before(directions), polynomial(directions, 1.0), weights(directions);  // Legendre's
  for (const Vector3& other : sphere.direction) {
    cosine.push_back(direction.dot(other));
  }
  for (std::size_t degree = 0; degree < sphere.rings; ++degree) {
    const auto l = static_cast<double>(degree);
    for (std::size_t i = 0; i < directions; ++i) {
      weights[i] += (2.0 * l + 1.0) / (4.0 * std::numbers::pi) * polynomial[i];
      const double next = ((2.0 * l + 1.0) * cosine[i] * polynomial[i] - l * before[i]) / (l + 1.0);
      before[i] = std::exchange(polynomial[i], next);
    }
  }
  for (std::size_t i = 0; i < directions; ++i) {
    weights[i] *= sphere.weight[i];
  }
  return weights;
}

/// Several modes at once, because each addition waits for the one before.
std::vector<std::complex<double>> pressure_in_direction(const sound_maps::SoundMap& map, const Vector3& direction) {
  constexpr std::size_t at_once = 8;
  const std::vector<double> weights = weights_in_direction(map.sphere, direction);
  std::vector<std::complex<double>> pressure;
  for (std::size_t first = 0; first < map.modes(); first += at_once) {
    std::array<const std::complex<double>*, at_once> of_mode;
    for (std::size_t k = 0; k < at_once; ++k) {
      of_mode[k] = map.sphere.pressure.data() + std::min(first + k, map.modes() - 1) * weights.size();
    }
    std::array<RealAndImaginary, at_once> sums{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      for (std::size_t k = 0; k < at_once; ++k) {
        RealAndImaginary value;
        std::memcpy(&value, of_mode[k] + i, sizeof value);
        sums[k] += weights[i] * value;
      }
    }
    for (const RealAndImaginary& sum : sums) {
      pressure.emplace_back(sum[0], sum[1]);
    }
  }
  pressure.resize(map.modes());
  return pressure;
}

}  // namespace idiophone::voices
