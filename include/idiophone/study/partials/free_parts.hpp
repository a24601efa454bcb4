#pragma once
// The parts of a recording in which a struck body sounds freely.

#include <span>
#include <vector>

namespace idiophone::partials {

/// A part of a sound, s.
struct FreePart {
  double start = 0.0;
  double duration = 0.0;
};

/// Finds blows and clicks: a millisecond whose second difference has ten times the power of each of the twenty before.
/// It sees neither hum nor noise nor beats. The sound may also begin with a blow. A free part begins 20 ms after the
/// loudest sample of a blow or click, or after a tenth of what follows if that is less, and ends before the next one.
/// Without any, the blow is where the sound has reached half of its largest amplitude.
/// @param samples  [samples] in any unit, at least one
/// @param rate     samples per second
/// @return at least one; first the part with the most energy of its first differences times its length, counted up to 1
/// s
[[nodiscard]] std::vector<FreePart> free_parts(std::span<const double> samples, double rate);

}  // namespace idiophone::partials
