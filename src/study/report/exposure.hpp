#pragma once
// The A-weighted energy of a sound, and how it spreads over frequencies.

#include <span>

namespace idiophone::report {

struct Exposure {
  double level = 0.0;    ///< A-weighted sound exposure, dB re one unit^2 s
  double highest = 0.0;  ///< Hz; all but 1e-4 of the exposure is below. Half the rate of a sound that is silent
};

/// Sums the energy of overlapping blocks, so that every part of the sound has the same weight.
/// @param samples  [samples] in any unit
/// @param rate     samples per second
[[nodiscard]] Exposure exposure(std::span<const double> samples, double rate);

}  // namespace idiophone::report
