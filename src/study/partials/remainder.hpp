#pragma once
// A sound's spectrum after lines are subtracted, and its remaining peaks.

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "line.hpp"

namespace idiophone::partials {

/// Full width at half power of a line that does not decay, bins.
inline constexpr double window_width = 2.5;

/// Which peaks count as lines; see PartialOptions.
struct SearchOptions {
  BinRange reported;            ///< bins of the lines to be found; lines outside are fitted, too, as they overlap
  double prominence = 0.0;      ///< power ratio to the noise
  double dynamic_range = 0.0;   ///< power ratio of the strongest to the faintest bin
  double separation = 0.0;      ///< radians per sample
  std::size_t noise_reach = 0;  ///< bins, see noise_power
  std::size_t most = 0;         ///< lines within `reported`
};

/// The spectrum of a sound under the window, [bins].
/// @param samples  [line_spectrum.length()]
[[nodiscard]] Bins spectrum_of(const LineSpectrum& line_spectrum, std::span<const double> samples);

/// A spectrum minus lines.
class Remainder {
 public:
  /// @param samples  [line_spectrum.length()]
  Remainder(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options);

  void subtract(const Line& line) { add(line, -1.0); }
  void add_back(const Line& line) { add(line, 1.0); }

  /// The target of a fit of subtracted lines: the remainder plus these lines, [band].
  [[nodiscard]] Bins target(const std::vector<Line>& lines, BinRange band) const;

  /// Mean power of the noise, [bins].
  [[nodiscard]] std::vector<double> noise() const;

  /// Power above which a bin holds a line, [bins].
  [[nodiscard]] std::vector<double> limits() const;

  /// Power below which peaks are ignored.
  [[nodiscard]] double faintest() const { return faintest_; }

  /// Largest magnitude in a band of the whole spectrum, lines included.
  [[nodiscard]] double highest(BinRange band) const;

  /// The strongest peak above the limits that has not been returned yet; none if there are no more.
  [[nodiscard]] std::optional<std::size_t> next_peak();

  /// Allows peaks to be returned again.
  void forget_peaks() { std::fill(given_.begin(), given_.end(), 0); }

  /// First guess of a line from a peak: damping from its width, amplitude from its height.
  [[nodiscard]] Line line_at(std::size_t peak) const;

 private:
  void add(const Line& line, double factor);
  [[nodiscard]] bool is_peak(std::size_t bin) const;

  const LineSpectrum& line_spectrum_;
  const SearchOptions& options_;
  Bins spectrum_;            // of the whole sound
  Bins rest_;                // minus the subtracted lines
  std::vector<char> given_;  // 1: a peak that has been returned
  double faintest_ = 0.0;
};

}  // namespace idiophone::partials
