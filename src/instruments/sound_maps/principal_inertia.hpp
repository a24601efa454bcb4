#pragma once
// How hard a body is to turn, from its surface.

#include <Eigen/Geometry>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// About the centre of mass.
struct PrincipalInertia {
  Vector3 moments = Vector3::Zero();                         ///< kg m2, ascending
  Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();  ///< turns x, y and z into the principal axes
};

/// Of a solid of uniform density whose surface is closed: the sum over the tetrahedra between the centre of mass and
/// the triangles. The integral of x x^T over a tetrahedron of volume V with corners 0, a, b, c is V/20 (a a^T + b b^T +
/// c c^T
/// + s s^T) with s = a + b + c.
[[nodiscard]] PrincipalInertia principal_inertia(const SoundMap& map);

}  // namespace idiophone::sound_maps
