#pragma once
// Filters that change levels only.

#include <cstddef>
#include <functional>
#include <vector>

namespace idiophone::receivers {

/// The filter with a given real response, by a cosine series: symmetric about the middle, [2 half_width + 1] taps.
/// @param half_width  audio samples before and after the middle
/// @param rate        audio samples per second
/// @param gain        amplitude factor at a frequency (Hz), from 0 to half the rate
[[nodiscard]] std::vector<double> zero_phase_filter(std::size_t half_width, int rate,
                                                    const std::function<double(double frequency)>& gain);

}  // namespace idiophone::receivers
