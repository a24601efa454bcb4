#pragma once
// Fractional delay: a sound that arrives between two audio samples is spread over the samples around it.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "idiophone/lanes.hpp"

namespace idiophone::listening {

/// Weights of the audio samples around an arrival, for a sound and for its derivative with respect to time in audio
/// samples. Tabulated as Hermite cubics over the fraction of a sample; the error is below 1e-8.
class Spreading {
 public:
  /// The paper's splat over four samples: a Gaussian with a standard deviation of half a sample (the paper's width of
  /// two samples is +-2 standard deviations), corrected so that the weights add up to one and their centroid is the
  /// arrival: w(n) = exp(-2 x^2) (a + b x), x = n - arrival. A plain sampled Gaussian would be up to 0.02
  /// samples early or late. It has no derivative.
  [[nodiscard]] static const Spreading& splat();

  /// Twelve samples: the least-squares fit to the exact delay, and to its derivative, over the frequencies up to 0.4 of
  /// the rate. The error is below 0.13 dB there. Constants and ramps are exact.
  [[nodiscard]] static const Spreading& band_limited();

  /// Number of samples that an arrival is spread over, a multiple of 4.
  [[nodiscard]] std::size_t width() const { return groups_ * lane_count; }

  /// The first of them, relative to the last audio sample that is not after the arrival.
  [[nodiscard]] std::int64_t first() const { return 1 - static_cast<std::int64_t>(width() / 2); }

  /// Whether change() may be called.
  [[nodiscard]] bool differentiates() const { return !change_.empty(); }

  /// An arrival as a sample, a cell of the tables, and the position in the cell.
  struct ArrivalCell {
    std::int64_t before;  ///< last audio sample that is not after the arrival
    std::size_t cell;     ///< of the tables
    double rest;          ///< in the cell, 0 to 1
  };

  /// @param arrival  in audio samples, 0 to 2^40
  [[nodiscard]] static ArrivalCell cell_of(double arrival) {
    const double place = arrival * cells;
    const auto cell = static_cast<std::int64_t>(place);
    return {cell >> cell_bits, static_cast<std::size_t>(cell & (cells - 1)), place - static_cast<double>(cell)};
  }

  /// Weights of the samples first() + 4 group to first() + 4 group + 3 for the sound.
  [[nodiscard]] Lanes4 sound(const ArrivalCell& at, std::size_t group) const { return evaluate(sound_, at, group); }
  /// The same for its derivative.
  [[nodiscard]] Lanes4 change(const ArrivalCell& at, std::size_t group) const { return evaluate(change_, at, group); }

  /// A formula: [width] weights for an arrival at this fraction of a sample, which may lie a little outside 0 to 1.
  using Formula = std::function<std::vector<double>(double fraction)>;

 private:
  using Cubic = std::array<Lanes4, 4>;

  Spreading(std::size_t groups, const Formula& sound, const Formula& change);
  [[nodiscard]] std::vector<Cubic> tabulate(const Formula& formula) const;
  [[nodiscard]] Lanes4 evaluate(const std::vector<Cubic>& table, const ArrivalCell& at, std::size_t group) const {
    const Cubic& cubic = table[at.cell * groups_ + group];
    return cubic[0] + at.rest * (cubic[1] + at.rest * (cubic[2] + at.rest * cubic[3]));
  }

  static constexpr int cell_bits = 7;
  static constexpr int cells = 1 << cell_bits;  // in an audio sample
  std::size_t groups_;                          // of four samples
  std::vector<Cubic> sound_;                    // [cells][groups]
  std::vector<Cubic> change_;                   // likewise, or empty
};

/// The splat's formula.
[[nodiscard]] std::vector<double> gaussian_splat(double fraction);

/// The weights w(n), n = 1 - width/2 to width/2, that minimise the integral of |sum_n w(n) exp(-i f (n - fraction)) -
/// (i f)^derivative|^2 over angular frequencies f from 0 to 0.8 pi per sample, their sum and first moment exact.
[[nodiscard]] std::vector<double> least_squares_spreading(double fraction, std::size_t width, int derivative);

}  // namespace idiophone::listening
