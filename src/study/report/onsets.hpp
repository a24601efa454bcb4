#pragma once
// When sounds begin, heard from a recording alone.

#include <span>
#include <vector>

namespace idiophone::report {

/// Times at which the A-weighted level jumps in most octave bands at once, as after a blow. Partials that beat raise
/// the level in their own band only, and not above its level of the last 0.1 s.
/// @param samples  [samples] in any unit
/// @param rate     samples per second
/// @return s, ascending, to 0.01 s; at least 0.1 s apart. Levels 60 dB below the loudest are ignored
[[nodiscard]] std::vector<double> onsets(std::span<const double> samples, double rate);

}  // namespace idiophone::report
