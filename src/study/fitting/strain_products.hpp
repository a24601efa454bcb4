#pragma once
// How a mode strains its body, as the stiffness matrix sees it.

#include <span>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::fitting {

/// Q_pq, the integral of E_p E_q over the body, m3, with the strain E of a mode shape in the order of
/// solid::StiffnessMatrix. For unit modal mass C : Q = w^2 (kg m2) for every stiffness C whose mode this is, and
/// dC : Q = d(w^2) for small changes of C (Hellmann and Feynman). By the quadrature of the internal force.
/// @param part   of one body, all of it on this rank
/// @param shape  [3 x nodes] m
[[nodiscard]] solid::StiffnessMatrix strain_products(const mesh::Part& part, std::span<const double> shape);

}  // namespace idiophone::fitting
