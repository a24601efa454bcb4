#pragma once
// Waves from edges as filters: radiation::edge_response() for delays in steps.

#include <array>
#include <cstdint>
#include <vector>

#include "idiophone/air/receivers/head_directions.hpp"

namespace idiophone::receivers {

/// Filter number n > 0 has the response of a delay of exp(n/2 - 6.5) audio samples. A delay between two of them
/// interpolates between two filters: within 0.1 dB. Number 0 passes a sound unchanged.
class EdgeFilters {
 public:
  explicit EdgeFilters(int rate) : taps_(static_cast<std::size_t>(rate) / 20) {}

  static constexpr double lowest = 1.0;    ///< number
  static constexpr double highest = 34.0;  ///< number

  /// The number for a delay, with a fraction: from `lowest` to `highest`.
  /// @param delay  in audio samples, at least 0
  [[nodiscard]] static double number_of(double delay);

  /// The filters below and above a number with a fraction.
  [[nodiscard]] static Crossfade between(double number);

  /// Audio samples of a response before its arrival.
  [[nodiscard]] static std::size_t lookahead() { return half_kernel; }
  /// 50 ms after the arrival, and the lookahead.
  [[nodiscard]] std::size_t taps() const { return taps_ + 1 + half_kernel; }

  /// [taps()]; flat up to 0.45 of the audio rate.
  [[nodiscard]] std::vector<double> response(std::int64_t number) const;

 private:
  static constexpr std::size_t half_kernel = 32;

  std::size_t taps_;
};

}  // namespace idiophone::receivers
