#pragma once
// The narrow Gaussian that brings a sound between two audio samples into the accumulation buffer.

#include <array>

#include "idiophone/lanes.hpp"

namespace idiophone::listening {

/// Weights of the four audio samples about an arrival: a Gaussian with a standard deviation of half a sample (two
/// samples wide, the paper says: +-2 standard deviations), bent slightly so that the weights' sum is exactly one and
/// their centroid exactly the arrival: w(n) = exp(-2 x^2) (a + b x), x = n - arrival. A plain sampled Gaussian would
/// be up to 0.02 samples early or late.
///
/// Tabulated as cubics (Hermite) over the fraction of a sample; off the formula by less than 1e-9.
class Splat {
 public:
  [[nodiscard]] static const Splat& instance();

  /// Weights of the samples -1, 0, 1, 2 from the whole part of the arrival, for its fraction in [0, 1).
  [[nodiscard]] Lanes weights(double fraction) const {
    const double place = fraction * cells;
    const auto cell = static_cast<std::size_t>(place);
    const double rest = place - static_cast<double>(cell);
    const auto& cubic = cubics_[cell];
    return cubic[0] + rest * (cubic[1] + rest * (cubic[2] + rest * cubic[3]));
  }

  /// The formula.
  [[nodiscard]] static std::array<double, lane_count> exact(double fraction);

 private:
  Splat();

  static constexpr int cells = 128;
  std::array<std::array<Lanes, 4>, cells> cubics_;
};

}  // namespace idiophone::listening
