#pragma once
// Nonlinear least squares: the damped sines whose spectra add up to a given stretch of spectrum.

#include <span>
#include <vector>

#include "line.hpp"

namespace idiophone::analysis {

/// Moves frequencies, dampings and amplitudes of all lines together (Levenberg-Marquardt) to where the sum of their
/// spectra is nearest to the target.
/// @param target  [band] spectrum that the lines shall make up
/// @param start   where to begin; a line that ends up at a negative frequency is returned as its mirror image
[[nodiscard]] std::vector<Line> fit_lines(const LineSpectrum& line_spectrum, std::span<const Complex> target,
                                          BinRange band, const std::vector<Line>& start);

/// Standard deviations of a fitted line, infinite where the spectrum does not determine it.
struct Deviation {
  double frequency = 0.0;  ///< radians per sample
  double damping = 0.0;    ///< 1 per sample
};

/// Deviations of fitted lines, if what they leave of the target is noise: diagonal of s^2 (J^T J)^-1.
/// @param target  [band] as it was fitted
[[nodiscard]] std::vector<Deviation> deviations(const LineSpectrum& line_spectrum, std::span<const Complex> target,
                                                BinRange band, const std::vector<Line>& lines);

}  // namespace idiophone::analysis
