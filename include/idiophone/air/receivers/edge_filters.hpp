#pragma once
// Waves from edges as filters: radiation::edge_response() for delays in steps.

#include <array>
#include <cstdint>
#include <vector>

#include "idiophone/air/radiation/shortest_way.hpp"
#include "idiophone/air/receivers/head_directions.hpp"

namespace idiophone::receivers {

/// A wave from an edge: `gain` times what goes through a filter of EdgeFilters. Its number may have a fraction.
struct NumberedWave {
  double gain = 0.0;
  double number = 0.0;
};
/// The waves of each of the edges in turn that a sound goes around. Those of edges add, and edges multiply.
using WavesInTurn = std::array<std::array<NumberedWave, 2>, radiation::most_in_turn>;
/// A sound that passes unchanged.
constexpr WavesInTurn no_edges = {{{{{1.0, 0.0}, {}}}, {{{1.0, 0.0}, {}}}, {{{1.0, 0.0}, {}}}}};

/// Filter number n > 0 has the response of a delay of exp(n/2 - 6.5) audio samples. A delay between two of them
/// interpolates between two filters: within 0.1 dB. Number 0 passes a sound unchanged. Number n + 35 m + 35² k is
/// filters n, m and k in series, for edges in turn.
class EdgeFilters {
 public:
  /// @param in_turn  most edges in turn, 1 to radiation::most_in_turn
  explicit EdgeFilters(int rate, std::size_t in_turn = 1)
      : taps_(static_cast<std::size_t>(rate) / 20), in_turn_(in_turn) {}

  static constexpr double lowest = 1.0;    ///< number
  static constexpr double highest = 34.0;  ///< number

  /// The number for a delay, with a fraction: from `lowest` to `highest`.
  /// @param delay  in audio samples, at least 0
  [[nodiscard]] static double number_of(double delay);

  /// The filters whose sum the waves are.
  [[nodiscard]] std::vector<FilterWeight> filters_of(const WavesInTurn& waves) const;

  /// Audio samples of a response before its arrival.
  [[nodiscard]] std::size_t lookahead() const { return in_turn_ * half_kernel; }
  /// 50 ms after the arrival, and the lookahead, for each edge in turn.
  [[nodiscard]] std::size_t taps() const { return in_turn_ * (single_taps() - 1) + 1; }

  /// [taps()]; flat up to 0.45 of the audio rate.
  [[nodiscard]] std::vector<double> response(std::int64_t number) const;

 private:
  static constexpr std::size_t half_kernel = 32;
  static constexpr auto single_filters = static_cast<std::int64_t>(highest) + 1;

  [[nodiscard]] std::size_t single_taps() const { return taps_ + 1 + half_kernel; }
  /// [single_taps()] of filters below single_filters.
  [[nodiscard]] std::vector<double> single_response(std::int64_t number) const;

  std::size_t taps_, in_turn_;
};

}  // namespace idiophone::receivers
