#pragma once
// A force over time, audio sample by audio sample.

#include <vector>

namespace idiophone::resonators {

/// Force in one audio sample: mean + slope (2 s - 1), where s goes from 0 to 1 in the sample. N
struct ForcePiece {
  double mean = 0.0;
  double slope = 0.0;
  double begin = 0.0;  ///< the force itself at s = 0; a force that is not linear differs from mean - slope
  double rise = 0.0;   ///< by which it grows in a sample, smoothed (add_rise())
};

/// A force that is linear in the sample. @param begin, end  N
[[nodiscard]] constexpr ForcePiece linear_piece(double begin, double end) {
  return {.mean = 0.5 * (begin + end), .slope = 0.5 * (end - begin), .begin = begin};
}

/// A force from its first audio sample on.
using ForceCurve = std::vector<ForcePiece>;

}  // namespace idiophone::resonators
