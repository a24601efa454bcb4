#pragma once
// Frequency weightings of hearing.

namespace idiophone::levels {

/// The frequency weighting A as a factor, 1 at 1000 Hz (IEC 61672-1, annex E).
/// @param frequency  Hz
[[nodiscard]] double a_weighting(double frequency);

}  // namespace idiophone::levels
