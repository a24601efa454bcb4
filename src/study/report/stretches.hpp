#pragma once
// The sound of each blow by itself, with its partials.

#include <span>
#include <vector>

#include "idiophone/study/partials/partials.hpp"
#include "impacts.hpp"

namespace idiophone::report {

/// The sound of one blow, until the next one.
struct Stretch {
  double peak = 0.0;      ///< the largest sample soon after the blow, in the unit of the sound
  double start = 0.0;     ///< of the analysis, s: when the blow itself is over, and the bodies part
  double duration = 0.0;  ///< of the analysis, s, at most 4; 0 if the next blow comes too soon for one
  partials::Partials partials = {};
};

/// Finds the partials of each blow, down to 60 dB below its strongest one.
/// @param samples  [samples] in any unit
/// @param rate     samples per second
/// @return [impacts]
[[nodiscard]] std::vector<Stretch> stretches(std::span<const double> samples, double rate,
                                             std::span<const Impact> impacts);

/// The largest sample of each impact soon after it. @return [impacts]
[[nodiscard]] std::vector<double> peaks(std::span<const double> samples, double rate, std::span<const Impact> impacts);

/// The one with the largest peak.
/// @param stretches  not empty
[[nodiscard]] const Stretch& loudest(std::span<const Stretch> stretches);

}  // namespace idiophone::report
