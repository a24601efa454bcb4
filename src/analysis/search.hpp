#pragma once
// The search for lines in a spectrum, from the strongest down.

#include <span>
#include <vector>

#include "fit.hpp"
#include "line.hpp"

namespace idiophone::analysis {

/// What to take for a line; see PartialOptions.
struct SearchOptions {
  Band reported;                ///< bins whose lines count; others are found too, so that they do not disturb
  double prominence = 0.0;      ///< power ratio to the noise
  double dynamic_range = 0.0;   ///< power ratio of the strongest to the faintest bin
  double separation = 0.0;      ///< radians per sample
  std::size_t noise_reach = 0;  ///< bins, see noise_power
  std::size_t most = 0;         ///< lines within `reported`
};

/// A line found, with what is left around it when all lines are taken out.
struct FoundLine {
  Line line;
  Deviation deviation;
  double prominence = 0.0;  ///< power ratio of the line's height to the noise
};

/// Finds the lines of a sound.
/// @param samples  [line_spectrum.length()]
[[nodiscard]] std::vector<FoundLine> find_lines(const LineSpectrum& line_spectrum, std::span<const double> samples,
                                                const SearchOptions& options);

}  // namespace idiophone::analysis
