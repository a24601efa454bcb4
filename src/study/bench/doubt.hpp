#pragma once
// What two ways to take the lines of taps for modes disagree about.

#include <cstddef>
#include <vector>

#include "idiophone/study/bench/learning.hpp"
#include "tap_hypotheses.hpp"

namespace idiophone::bench {

/// @param mode   about which the rival contradicts the likeliest way (certainness_of())
/// @param lines  of the last tap
[[nodiscard]] Doubt doubt_between(const TapHypothesis& likeliest, const TapHypothesis& rival, std::size_t mode,
                                  const std::vector<fitting::Line>& lines);

}  // namespace idiophone::bench
