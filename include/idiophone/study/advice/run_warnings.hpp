#pragma once
// What a user should know before a long run.

#include <string>
#include <vector>

#include "idiophone/run/bodies/preparation.hpp"

namespace idiophone::advice {

/// On rank 0:
/// - listeners inside an unbounded obstacle, which hear nothing
/// - bodies for which the radiation model is wrong (radiation_warnings.hpp)
/// - loads and driven groups whose frequency nobody can hear, or which the steps of the motion do not resolve, or
///   which start after the end of the sound
[[nodiscard]] std::vector<std::string> run_warnings(const bodies::Preparation& ready);

/// Prints them, on rank 0.
void report_doubts(const bodies::Preparation& ready);

}  // namespace idiophone::advice
