#pragma once
// Triangles with six nodes in a plane region: the mesh of a membrane.

#include <array>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mesh {

using Point2 = std::array<double, 2>;  ///< x and y, m

/// A region of the plane: a polygon, or a disc about the origin.
struct PlaneRegion {
  std::vector<Point2> polygon;  ///< corners in order around it, either way; empty for a disc
  double radius = 0.0;          ///< of a disc, m
};

struct PlaneMesh {
  std::vector<Point2> nodes;                   ///< m
  std::vector<std::array<Index, 6>> elements;  ///< corners 0 1 2 counter-clockwise, then the middles of 01, 12 and 20
  std::vector<Index> rim;                      ///< nodes of the boundary, ascending
};

/// Meshes a region by gmsh. Towards re-entrant corners, where modes have infinite slopes, elements become small in a
/// geometric series. Call on one rank only.
/// @param size  of the elements, m
/// @throws std::runtime_error when gmsh can't, for instance because a polygon crosses itself
[[nodiscard]] PlaneMesh mesh_region(const PlaneRegion& region, double size);

}  // namespace idiophone::mesh
