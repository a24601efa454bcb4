#pragma once
// A plane region as a script of gmsh.

#include <string>
#include <vector>

#include "idiophone/solids/mesh/plane_region.hpp"

namespace idiophone::mesh {

/// Corners at which a region has more than 180 degrees, m.
[[nodiscard]] std::vector<Point2> re_entrant_corners(const PlaneRegion& region);

/// gmsh's script of a region, which meshes it itself: triangles, not quadrilaterals.
/// @param size  of the elements, m
[[nodiscard]] std::string script_of(const PlaneRegion& region, double size);

}  // namespace idiophone::mesh
