#pragma once
// Sound between its samples.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace idiophone::timbre {

/// Samples that the interpolation needs on each side, if it keeps all frequencies.
inline constexpr int interpolation_reach = 16;

/// The value at a position between samples: a sinc under a squared cosine.
/// @param sample    sample(index) for any index
/// @param position  in samples
/// @param share     of the frequencies that pass, 1 for all; less for sounds that are played faster
template <class Sample>
[[nodiscard]] double interpolated(const Sample& sample, double position, double share = 1.0) {
  const double reach = interpolation_reach / share;
  const auto last = static_cast<std::int64_t>(std::floor(position + reach));
  double sum = 0.0;
  for (auto k = static_cast<std::int64_t>(std::ceil(position - reach)); k <= last; ++k) {
    const double x = position - static_cast<double>(k);
    const double angle = std::numbers::pi * share * x;
    const double sinc = std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle;
    const double window = std::cos(0.5 * std::numbers::pi * x / reach);
    sum += share * sinc * window * window * sample(k);
  }
  return sum;
}

}  // namespace idiophone::timbre
