#pragma once
// Turns of a material's axes that nobody can hear: by the symmetry of the material, and by that of its body.

#include <Eigen/Core>
#include <vector>

#include "turned_material.hpp"

namespace idiophone::fitting {

/// Rotations that leave the stiffness of a material as it is, of those by quarters about its axes and by sixths about
/// its z. They contain all that a crystal of any symmetry has.
[[nodiscard]] std::vector<Eigen::Matrix3d> symmetries_of(const scene::Material& material);

/// Rotations that bring a box into itself; sides within 1 % count as equal.
/// @param axes     of the box, in the columns
/// @param extents  along them, m
[[nodiscard]] std::vector<Eigen::Matrix3d> symmetries_of_box(const Eigen::Matrix3d& axes, const Vector3& extents);

/// Of a rotation times each symmetry of the material, the one by the smallest angle.
[[nodiscard]] Eigen::Matrix3d smallest_turn(const Eigen::Matrix3d& rotation,
                                            const std::vector<Eigen::Matrix3d>& symmetries);

/// The angle of a rotation, degrees.
[[nodiscard]] double angle_of(const Eigen::Matrix3d& rotation);

/// Whether a turn about one of its axes, after those before it, leaves the stiffness as it is: any such turn.
/// @param axis  0 for turns[0], ...
[[nodiscard]] bool is_round_about(int axis, const TurnedMaterial& material);

}  // namespace idiophone::fitting
