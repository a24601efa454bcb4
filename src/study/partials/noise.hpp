#pragma once
// The noise level under the lines of a spectrum.

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone::partials {

/// Mean power of the noise in each bin of a spectrum padded to twice the sound's length.
///
/// Noise is uncorrelated between bins: its power follows from d_k = S_k - (S_{k-4} + S_{k+4})/2, in which broad lines,
/// transients and the flanks of lines vanish. Narrow lines are few, so they hardly change the median over the bins
/// around. For Gaussian noise the mean of |d|^2 is median/ln 2, and 3/2 of the noise power. "Around" reaches an
/// octave down and up, but not more than `reach` bins and not less than 80.
[[nodiscard]] std::vector<double> noise_power(std::span<const std::complex<double>> spectrum, std::size_t reach);

}  // namespace idiophone::partials
