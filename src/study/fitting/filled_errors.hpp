#pragma once
// Errors of modes between those whose errors are estimated.

#include <vector>

namespace idiophone::fitting {

/// Errors of the mesh grow with the frequency, but not evenly, because modes of several kinds follow one another. A
/// mode without an estimate gets the larger one of the next estimates below and above it.
/// @param errors  [modes] ascending by frequency; NaN without an estimate
/// @return [modes] those above the highest estimate are still NaN
[[nodiscard]] std::vector<double> filled_errors(std::vector<double> errors);

}  // namespace idiophone::fitting
