#include "idiophone/air/receivers/absorbing_air.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::receivers {

std::vector<double> AbsorbingAir::response(std::int64_t number) const {
  // The cosine series of the frequency response, by the trapezoidal rule from 0 to half the rate.
  const std::size_t half = half_width();
  const std::size_t steps = 1024 + 4 * half;
  std::vector<double> taps(2 * half + 1);
  for (std::size_t step = 0; step <= steps; ++step) {
    const double fraction = static_cast<double>(step) / static_cast<double>(steps);
    const double weight = (step == 0 || step == steps ? 0.5 : 1.0) / static_cast<double>(steps);
    const double gain = std::exp(-atmosphere_.attenuation(0.5 * fraction * rate_) * static_cast<double>(number));
    for (std::size_t k = 0; k <= half; ++k) {
      taps[half + k] += weight * gain * std::cos(std::numbers::pi * fraction * static_cast<double>(k));
    }
  }
  for (std::size_t k = 1; k <= half; ++k) {
    taps[half - k] = taps[half + k];
  }
  return taps;
}

}  // namespace idiophone::receivers
