#pragma once
// Which measured line each mode of a body has.

#include <optional>
#include <span>
#include <vector>

#include "idiophone/study/fitting/measurements.hpp"

namespace idiophone::fitting {

struct LinesOfModes {
  double shift = 0.0;                      ///< cents by which all modes were raised first
  std::vector<std::optional<Line>> lines;  ///< [modes] none of a mode that was not measured
};

/// The cheapest assignment of lines to modes that keeps their order, after the likeliest common shift of all modes, of
/// at most 1000 cents. Of several lines of one mode the nearest counts.
/// @param frequencies  of the modes, Hz, ascending
/// @param lines        ascending
/// @param tolerance    the largest distance of a line from its raised mode, cents
[[nodiscard]] LinesOfModes lines_of_modes(std::span<const double> frequencies, const std::vector<Line>& lines,
                                          double tolerance);

}  // namespace idiophone::fitting
