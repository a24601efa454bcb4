#pragma once
// How much each mass counts in a sum over surface triangles.

#include <functional>

#include "idiophone/instruments/proxies/tetrahedral_mesh.hpp"
#include "spring_rows.hpp"

namespace idiophone::proxies {

/// What makes dot(weights, displacements) the sum of normal deviation times area over some triangles (O'Morain 2005,
/// section 6.6), [masses] m2.
/// @param is_heard  whether a triangle counts, by its area times its outward normal, m2
/// @param weights   of padded length
void weigh_surface(const TetrahedralMesh& mesh, const std::function<bool(const Vector3& area)>& is_heard,
                   Rows& weights);

}  // namespace idiophone::proxies
