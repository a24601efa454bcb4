#include "idiophone/listening/splat.hpp"

#include <cmath>

namespace idiophone::listening {

std::array<double, lane_count> Splat::exact(double fraction) {
  std::array<double, lane_count> offset{}, gaussian{};
  double moment0 = 0.0, moment1 = 0.0, moment2 = 0.0;
  for (std::size_t tap = 0; tap < lane_count; ++tap) {
    offset[tap] = static_cast<double>(tap) - 1.0 - fraction;
    gaussian[tap] = std::exp(-2.0 * offset[tap] * offset[tap]);
    moment0 += gaussian[tap];
    moment1 += gaussian[tap] * offset[tap];
    moment2 += gaussian[tap] * offset[tap] * offset[tap];
  }
  const double determinant = moment0 * moment2 - moment1 * moment1;
  std::array<double, lane_count> weights{};
  for (std::size_t tap = 0; tap < lane_count; ++tap) {
    weights[tap] = gaussian[tap] * (moment2 - moment1 * offset[tap]) / determinant;
  }
  return weights;
}

const Splat& Splat::instance() {
  static const Splat splat;
  return splat;
}

Splat::Splat() {
  constexpr double step = 1.0 / cells;
  constexpr double tiny = step / 8.0;
  const auto value = [](double fraction) { return load(exact(fraction).data()); };
  // Over one cell, by a difference of fourth order: keeps the sum and the centroid exact, as any linear rule does.
  const auto slope = [&](double at) {
    const Lanes near = value(at + tiny) - value(at - tiny);
    const Lanes far = value(at + 2.0 * tiny) - value(at - 2.0 * tiny);
    return (8.0 * near - far) * (step / (12.0 * tiny));
  };
  for (int cell = 0; cell < cells; ++cell) {
    const double begin = cell * step;
    const double end = begin + step;
    const Lanes rise = value(end) - value(begin);
    cubics_[cell] = {value(begin), slope(begin), 3.0 * rise - 2.0 * slope(begin) - slope(end),
                     slope(begin) + slope(end) - 2.0 * rise};
  }
}

}  // namespace idiophone::listening
