#pragma once
// How much mass selective mass scaling may add to the relative motion of the nodes of one through-thickness column
// (Olovsson, Simonsson and Unosson, International Journal for Numerical Methods in Engineering 63, 2005).

#include "idiophone/scene/material.hpp"

namespace idiophone::solid {

inline constexpr double highest_audible = 20e3;  ///< Hz

/// Added mass of each kind of relative motion, as a multiple of the mass that this motion has anyway. "Linear" and
/// "quadratic" are shapes across the column; the director is the column's current direction.
struct MassScaling {
  double stretch = 0.0;    ///< linear, along the director
  double bow = 0.0;        ///< quadratic, along the director
  double rotation = 0.0;   ///< linear, at right angles to the director
  double plane_bow = 0.0;  ///< quadratic, at right angles to the director
};

/// By how much the pitch of waves in a plate falls, cents. Shares of the kinetic energy are those of thin plates: with
/// wave number k and nu' = nu/(1 - nu), stretch has nu'^2 (k h)^2/12 in waves of stretching, bow nu'^2 (k h)^4/720 and
/// rotation (k h)^2/12 in waves of bending (1.3 times that near free edges).
/// @param thickness  h, m
/// @param frequency  Hz
[[nodiscard]] double predicted_shift(const MassScaling& scaling, const scene::Material& material, double thickness,
                                     double frequency);

/// The largest scaling that moves no wave up to a frequency by more than the shift.
/// @param thickness  of the column, m
/// @param frequency  the highest that is to be heard, Hz
/// @param shift      cents
[[nodiscard]] MassScaling choose_scaling(const scene::Material& material, double thickness, double frequency,
                                         double shift);

}  // namespace idiophone::solid
