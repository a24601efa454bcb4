#pragma once
// How long the blocks are that work goes on in: nothing in the result depends on it.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace idiophone::loop {

inline constexpr std::int64_t longest_block = 8192;  ///< audio samples

/// Audio samples in the first block, whose speed is not known yet: so few that it takes about a second at the most,
/// soon enough to stop.
/// @param steps  of the motion in an audio sample
/// @param nodes  that move in each step
[[nodiscard]] inline std::int64_t first_block(std::int64_t steps, std::int64_t nodes) {
  constexpr std::int64_t longest_first_block = 16;
  constexpr std::int64_t most_steps = 10'000;           // with contacts, a step of a small body takes some 100 us
  constexpr std::int64_t most_node_steps = 10'000'000;  // a core moves 10 to 50 million nodes a second
  const std::int64_t block = std::min(most_steps / steps, most_node_steps / (steps * std::max<std::int64_t>(1, nodes)));
  return std::clamp<std::int64_t>(block, 1, longest_first_block);
}

/// Audio samples in the block after one that took so many seconds: it shall take about two, soon enough to stop, long
/// enough to hide the writing.
/// @param longest  audio samples at the most
[[nodiscard]] inline std::int64_t next_block(std::int64_t block, double seconds, std::int64_t longest) {
  constexpr double wanted_seconds = 2.0;
  const double factor = std::clamp(wanted_seconds / std::max(seconds, 1e-6), 0.25, 4.0);
  return std::clamp<std::int64_t>(std::llround(static_cast<double>(block) * factor), 1, longest);
}

}  // namespace idiophone::loop
