#pragma once
// The search for lines in a spectrum, from the strongest down.

#include <span>
#include <vector>

#include "fit.hpp"
#include "line.hpp"
#include "remainder.hpp"

namespace idiophone::partials {

/// A line found, and its level over the noise after all lines are subtracted.
struct FoundLine {
  Line line;
  Deviation deviation;
  double prominence = 0.0;  ///< power ratio of the line's height to the noise
  double remainder = 0.0;   ///< power ratio of the highest peak left in the line's width to its height; 0 for noise
};

/// The lines of a sound.
struct FoundLines {
  std::vector<FoundLine> lines;
  bool complete = true;  ///< see Partials
};

/// Finds the lines of a sound.
/// @param samples  [line_spectrum.length()]
[[nodiscard]] FoundLines find_lines(const LineSpectrum& line_spectrum, std::span<const double> samples,
                                    const SearchOptions& options);

}  // namespace idiophone::partials
