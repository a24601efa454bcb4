#pragma once
// Euler's angles of axes, as Bunge gives the orientation of crystals (Texture Analysis in Materials Science, 1982,
// chapter 2).

#include <Eigen/Core>

#include "idiophone/foundation/types.hpp"

namespace idiophone::scene {

/// Axes after turns about z by phi1, about the new x by Phi and about the new z by phi2, in the columns.
/// @param degrees  phi1, Phi, phi2
[[nodiscard]] Eigen::Matrix3d axes_of_euler_angles(const Vector3& degrees);

/// The angles of such axes, degrees: phi1 and phi2 above -180 and up to 180, Phi from 0 to 180. Where both z axes lie
/// along one line, phi1 and phi2 are about the same line, and phi2 is 0.
/// @param axes  right-handed and at right angles, in the columns
[[nodiscard]] Vector3 euler_angles(const Eigen::Matrix3d& axes);

}  // namespace idiophone::scene
