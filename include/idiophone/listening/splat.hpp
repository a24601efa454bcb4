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
/// Tabulated as cubics (Hermite) over the fraction of a sample; off the formula by less than 2e-9.
class Splat {
 public:
  [[nodiscard]] static const Splat& instance();

  /// What four entries get of a sound: weights of the samples before - 1 to before + 2.
  struct Taps {
    std::int64_t before;  ///< last audio sample that is not after the arrival
    Lanes weights;
  };

  /// @param arrival  in audio samples, 0 to 2^40
  [[nodiscard]] Taps taps(double arrival) const {
    const double place = arrival * cells;
    const auto cell = static_cast<std::int64_t>(place);
    const double rest = place - static_cast<double>(cell);
    const auto& cubic = cubics_[cell & (cells - 1)];
    return {cell >> cell_bits, cubic[0] + rest * (cubic[1] + rest * (cubic[2] + rest * cubic[3]))};
  }

  /// The formula.
  [[nodiscard]] static std::array<double, lane_count> exact(double fraction);

 private:
  Splat();

  static constexpr int cell_bits = 7;
  static constexpr int cells = 1 << cell_bits;  // in an audio sample
  std::array<std::array<Lanes, 4>, cells> cubics_;
};

}  // namespace idiophone::listening
