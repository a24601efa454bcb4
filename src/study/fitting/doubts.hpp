#pragma once
// How far the lines are from the modes of a fit, and whether this is a reason to doubt it.

#include "idiophone/study/fitting/identification.hpp"

namespace idiophone::fitting {

/// Sums up the distances of the lines: Identification::fitted_rms, tested_rms, chi_squared and freedom.
/// @param result  with its constants and lines
void add_residuals(Identification& result);

/// Says why the fit is not accepted: false lines, or fitted lines that are too far from their modes for chance.
/// @param tolerance  the largest distance of a line from its mode, cents
/// @param result     with its residuals
void add_doubts(double tolerance, Identification& result);

}  // namespace idiophone::fitting
