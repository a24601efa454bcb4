#pragma once
// The static flexibility that some modes leave out.

#include <span>
#include <vector>

#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "shifted_stiffness.hpp"

namespace idiophone::eigenmodes {

/// The displacement along a unit vector by a unit force along it at a node, less that of the modes of a basis and of
/// rigid motions. [nodes], m/N
/// @param directions  [nodes]
/// @param stiffness   of the body, with a shift far below the lowest mode where it can move rigidly, and without one
///                    where it cannot
[[nodiscard]] std::vector<double> residual_flexibility(const ShiftedStiffness& stiffness, const mesh::Part& part,
                                                       const modal_bodies::ModalBasis& basis,
                                                       std::span<const Index> nodes,
                                                       std::span<const Vector3> directions);

}  // namespace idiophone::eigenmodes
