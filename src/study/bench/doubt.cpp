#include "doubt.hpp"

#include <algorithm>

namespace idiophone::bench {

namespace {

/// Which mode of a hypothesis has a line.
std::optional<std::size_t> owner_of(const TapHypothesis& hypothesis, std::size_t line) {
  const auto found = std::ranges::find(hypothesis.lines, line);
  return found == hypothesis.lines.end() ? std::nullopt : std::optional<std::size_t>(found - hypothesis.lines.begin());
}

}  // namespace

Doubt doubt_between(const TapHypothesis& likeliest, const TapHypothesis& rival, std::size_t mode,
                    const std::vector<fitting::Line>& lines) {
  const auto line = likeliest.lines[mode];
  const auto other_line = rival.lines[mode];
  if (const auto owner = line ? owner_of(rival, *line) : std::nullopt) {
    return {.mode = mode, .line = lines[*line].frequency, .other_line = {}, .other = owner};
  }
  if (const auto owner = other_line ? owner_of(likeliest, *other_line) : std::nullopt) {
    return {.mode = mode, .line = lines[*other_line].frequency, .other_line = {}, .other = owner};
  }
  // Neither line is that of another mode, so the mode has both.
  return {.mode = mode, .line = lines[*line].frequency, .other_line = lines[*other_line].frequency, .other = {}};
}

}  // namespace idiophone::bench
