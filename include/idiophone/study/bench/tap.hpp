#pragma once
// Taps on a body that is tuned.

#include <cstddef>
#include <optional>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/study/fitting/measurements.hpp"

namespace idiophone::bench {

/// The lines of a tap.
struct Tap {
  std::vector<fitting::Line> lines;  ///< ascending
  std::size_t cuts = 0;              ///< that had been made before
  std::optional<Vector3> at;         ///< where the body was struck, m; none: unknown
};

/// Lines without those that are 20 dB fainter than a line within 200 cents: of two modes that lie so near, the tap
/// excites only one well. Lines without a level stay.
[[nodiscard]] std::vector<fitting::Line> without_faint_neighbours(const std::vector<fitting::Line>& lines);

}  // namespace idiophone::bench
