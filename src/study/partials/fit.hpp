#pragma once
// Nonlinear least squares: the damped sines whose spectra add up to a part of a given spectrum.

#include <span>
#include <vector>

#include "line.hpp"

namespace idiophone::partials {

/// Lines that were fitted.
struct Fit {
  std::vector<Line> lines;
  int iterations = 0;  ///< refused steps, too; each solves a system of [4 x lines] equations
};

/// Finds the frequencies, dampings and amplitudes of all lines for which the sum of their spectra is nearest to the
/// target (Levenberg-Marquardt).
/// @param target           [band] spectrum to be fitted
/// @param start            initial values; a line at a negative frequency is returned as its mirror image
/// @param most_iterations  at least 1
[[nodiscard]] Fit fit_lines(const LineSpectrum& line_spectrum, std::span<const Complex> target, BinRange band,
                            const std::vector<Line>& start, int most_iterations);

/// Standard deviations of a fitted line, infinite if the spectrum does not determine it.
struct Deviation {
  double frequency = 0.0;  ///< radians per sample
  double damping = 0.0;    ///< 1 per sample
};

/// Deviations of fitted lines, assuming that the residual is noise: diagonal of s^2 (J^T J)^-1.
/// @param target  [band] the fitted spectrum
[[nodiscard]] std::vector<Deviation> deviations(const LineSpectrum& line_spectrum, std::span<const Complex> target,
                                                BinRange band, const std::vector<Line>& lines);

}  // namespace idiophone::partials
