#include "zero_phase.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::receivers {

std::vector<double> zero_phase_filter(std::size_t half_width, int rate,
                                      const std::function<double(double frequency)>& gain) {
  // By the trapezoidal rule from 0 to half the rate.
  const std::size_t steps = 1024 + 4 * half_width;
  std::vector<double> taps(2 * half_width + 1);
  for (std::size_t step = 0; step <= steps; ++step) {
    const double fraction = static_cast<double>(step) / static_cast<double>(steps);
    const double weight = (step == 0 || step == steps ? 0.5 : 1.0) / static_cast<double>(steps);
    const double level = gain(0.5 * fraction * rate);
    for (std::size_t k = 0; k <= half_width; ++k) {
      taps[half_width + k] += weight * level * std::cos(std::numbers::pi * fraction * static_cast<double>(k));
    }
  }
  for (std::size_t k = 1; k <= half_width; ++k) {
    taps[half_width - k] = taps[half_width + k];
  }
  return taps;
}

}  // namespace idiophone::receivers
