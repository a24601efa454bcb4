#pragma once
// Modes in which a body hardly bends, as on soft supports.

#include <Eigen/Core>

namespace idiophone::eigenmodes {

/// Whether a shape is nearly a rigid motion a + b x r: everywhere, it differs from one by less than a tenth of its
/// largest displacement.
/// @param places         [3 x points], m
/// @param displacements  [3 x points], in any unit
[[nodiscard]] bool is_rigid_motion(const Eigen::Ref<const Eigen::Matrix3Xd>& places,
                                   const Eigen::Ref<const Eigen::Matrix3Xd>& displacements);

}  // namespace idiophone::eigenmodes
