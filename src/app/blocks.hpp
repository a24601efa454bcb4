#pragma once
// How long the blocks are that work goes on in: nothing in the result depends on it.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace idiophone::app {

inline constexpr std::int64_t first_block = 16;      ///< audio samples
inline constexpr std::int64_t longest_block = 8192;  ///< audio samples

/// Audio samples in the block after one that took so many seconds: it shall take about two, soon enough to stop, long
/// enough to hide the writing.
/// @param longest  audio samples at the most
[[nodiscard]] inline std::int64_t next_block(std::int64_t block, double seconds, std::int64_t longest) {
  constexpr double wanted_seconds = 2.0;
  const double factor = std::clamp(wanted_seconds / std::max(seconds, 1e-6), 0.25, 4.0);
  return std::clamp<std::int64_t>(std::llround(static_cast<double>(block) * factor), 1, longest);
}

}  // namespace idiophone::app
