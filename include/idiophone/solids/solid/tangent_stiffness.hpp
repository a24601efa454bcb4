#pragma once
// The tangent stiffness of one element, for static equilibria.

#include <Eigen/Core>
#include <span>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::solid {

/// Derivative of an element's internal force (with its sign turned) by its nodes' displacements, elastic part only,
/// N/m.
/// @param reference     [nodes per element] X, m
/// @param displacement  [nodes per element] u, m
/// @param stress        where the body rests, Pa: what it adds is the geometric stiffness
/// @return [3 nodes x 3 nodes], row and column 3 a + i for node a and direction i; symmetric
[[nodiscard]] Eigen::MatrixXd tangent_stiffness(element::Type type, const Elasticity& elasticity,
                                                std::span<const Vector3> reference,
                                                std::span<const Vector3> displacement,
                                                const Eigen::Matrix3d& stress = Eigen::Matrix3d::Zero());

/// The same of a material that relaxes: it resists vibration by one elasticity, and has the stress of its rest by
/// another one.
/// @param relaxed  of the rest
[[nodiscard]] Eigen::MatrixXd tangent_stiffness(element::Type type, const Elasticity& elasticity,
                                                const Elasticity& relaxed, std::span<const Vector3> reference,
                                                std::span<const Vector3> displacement, const Eigen::Matrix3d& stress);

}  // namespace idiophone::solid
