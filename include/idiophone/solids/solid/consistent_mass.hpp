#pragma once
// The consistent mass of one element, for eigenfrequencies that converge from above. The motion in time uses the lumped
// one (Solid::add_mass).

#include <Eigen/Core>
#include <span>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::solid {

/// M_(ai)(bj) = delta_ij times the integral of density N_a N_b over the undeformed element, curved edges included, kg.
/// @param density    kg/m3
/// @param reference  [nodes per element] X, m
/// @return [3 nodes x 3 nodes], row and column 3 a + i for node a and direction i; symmetric
[[nodiscard]] Eigen::MatrixXd consistent_mass(element::Type type, double density, std::span<const Vector3> reference);

}  // namespace idiophone::solid
