#pragma once
// What is left of a sound's spectrum when lines are taken out of it, and the peaks that still stand in it.

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "line.hpp"

namespace idiophone::analysis {

/// Full width at half power of a line that does not decay, bins.
inline constexpr double window_width = 2.5;

/// What to take for a line; see PartialOptions.
struct SearchOptions {
  BinRange reported;            ///< bins whose lines count; others are found too, so that they do not disturb
  double prominence = 0.0;      ///< power ratio to the noise
  double dynamic_range = 0.0;   ///< power ratio of the strongest to the faintest bin
  double separation = 0.0;      ///< radians per sample
  std::size_t noise_reach = 0;  ///< bins, see noise_power
  std::size_t most = 0;         ///< lines within `reported`
};

/// A spectrum less lines.
class Remainder {
 public:
  /// @param samples  [line_spectrum.length()]
  Remainder(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options);

  void take_out(const Line& line) { add(line, -1.0); }
  void put_back(const Line& line) { add(line, 1.0); }

  /// What lines that are taken out have to make up: what is left, and they themselves, [band].
  [[nodiscard]] Bins target(const std::vector<Line>& lines, BinRange band) const;

  /// Mean power of the noise, [bins].
  [[nodiscard]] std::vector<double> noise() const;

  /// Power above which a bin holds a line, [bins].
  [[nodiscard]] std::vector<double> limits() const;

  /// Power below which no line is looked for.
  [[nodiscard]] double faintest() const { return faintest_; }

  /// Largest magnitude in a band of the whole spectrum, lines included.
  [[nodiscard]] double highest(BinRange band) const;

  /// The strongest peak above the limits that was not given before; none if there is no more.
  [[nodiscard]] std::optional<std::size_t> next_peak();

  /// Gives peaks again that were given before.
  void forget_peaks() { std::fill(given_.begin(), given_.end(), 0); }

  /// First guess of a line from a peak: damping from its width, amplitude from its height.
  [[nodiscard]] Line line_at(std::size_t peak) const;

 private:
  void add(const Line& line, double factor);
  [[nodiscard]] bool is_peak(std::size_t bin) const;

  const LineSpectrum& line_spectrum_;
  const SearchOptions& options_;
  Bins spectrum_;            // of the whole sound
  Bins rest_;                // less the lines taken out
  std::vector<char> given_;  // peaks given before
  double faintest_ = 0.0;
};

}  // namespace idiophone::analysis
