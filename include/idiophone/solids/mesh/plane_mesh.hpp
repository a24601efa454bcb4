#pragma once
// Triangles with six nodes in a plane region: the mesh of a membrane or of a thin plate.

#include <array>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/mesh/plane_region.hpp"

namespace idiophone::mesh {

/// An edge of a triangle on the boundary of the region.
struct RimEdge {
  std::array<Index, 2> ends = {};  ///< nodes at corners of the triangle
  Index middle = 0;                ///< node between them; on a circle, it is on the arc
  std::size_t contour = 0;         ///< 0: the outline; i: hole i - 1
  std::size_t side = 0;            ///< of the contour's polygon, from the corner of this number on; 0 of a circle
};

struct PlaneMesh {
  std::vector<Point2> nodes;                   ///< m
  std::vector<std::array<Index, 6>> elements;  ///< corners 0 1 2 counter-clockwise, then the middles of 01, 12 and 20
  std::vector<RimEdge> rim;                    ///< of the outline and of the holes
};

/// Meshes a region by gmsh. Towards re-entrant corners, where modes have infinite slopes, elements become small in a
/// geometric series. A circle has at least 24 edges. Call on one rank only.
/// @param size    of the elements, m
/// @param levels  how often elements at re-entrant corners are cut in half
/// @throws std::runtime_error when gmsh can't, for instance because a polygon crosses itself
[[nodiscard]] PlaneMesh mesh_region(const PlaneRegion& region, double size, int levels = 14);

}  // namespace idiophone::mesh
