#pragma once
// A beam between two ends, as springs at its middle. Theory: docs/method/joints.md.

#include "idiophone/scene/joint_section.hpp"

namespace idiophone::joints {

/// Both ends carry the middle of the beam along, each as if it were rigid. These springs pull the two middles together.
/// They are the beam's stiffness matrix without rigid motion, all 12 x 12 of it.
struct BeamStiffness {
  double axial = 0.0;    ///< E A/L, N/m
  double lateral = 0.0;  ///< 12 E I/((1 + phi) L^3) + 6 P/(5 L), N/m
  double bending = 0.0;  ///< E I/L + P L/12, N m/rad
  double torsion = 0.0;  ///< 2 G I/L, N m/rad
};

/// Of a round Timoshenko beam under the pull P: phi = 12 E I/(k G A L^2) with k = 6 (1 + nu)/(7 + 6 nu) (Cowper 1966).
/// The terms with P are the geometric stiffness of cubic beam elements (Przemieniecki 1968).
/// @param length  L, m
[[nodiscard]] BeamStiffness beam_stiffness(const scene::Shank& shank, double length);

}  // namespace idiophone::joints
