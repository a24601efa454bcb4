#pragma once
// The static flexibility that some modes leave out.

#include <span>
#include <vector>

#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "operators.hpp"

namespace idiophone::eigenmodes {

/// The displacement along a unit vector by a unit force along it at a node, less that of the modes of a basis and of
/// rigid motions. [nodes], m/N
/// @param directions  [nodes]
/// @param shift       far below the lowest mode, (rad/s)^2
[[nodiscard]] std::vector<double> residual_flexibility(const Operators& operators, const mesh::Part& part,
                                                       const modal_bodies::ModalBasis& basis,
                                                       std::span<const Index> nodes,
                                                       std::span<const Vector3> directions, double shift);

}  // namespace idiophone::eigenmodes
