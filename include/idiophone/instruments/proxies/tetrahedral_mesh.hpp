#pragma once
// Tetrahedra and their surface, the geometry that a proxy is made of.

#include <array>
#include <functional>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::proxies {

struct TetrahedralMesh {
  std::vector<Vector3> nodes;                    ///< m
  std::vector<std::array<Index, 4>> tetrahedra;  ///< node numbers, in any order
  std::vector<std::array<Index, 3>> surface;     ///< exterior triangles, whose normals point out of the body
  std::vector<std::size_t> origin{};  ///< [tetrahedra] of a piece: which ones of the unbroken body they are parts of
};

/// The exterior triangles of tetrahedra: the faces of one tetrahedron only, in ascending order of their sorted nodes.
[[nodiscard]] std::vector<std::array<Index, 3>> exterior_triangles(const std::vector<Vector3>& nodes,
                                                                   const std::vector<std::array<Index, 4>>& tetrahedra);

/// Whether the first and the last cells along x of a grid are neighbours.
enum class Seam { open, closed };

/// A grid of cells, each of six tetrahedra around a diagonal (Kuhn's subdivision), in any shape.
/// @param cells  at least one along each axis; at least three along a closed x
/// @param place  from a point of the unit cube to a point of the body, m. If the seam is closed, x = 0 and x = 1 have
///               the same places, as an angle has.
/// @throws std::invalid_argument when there are too few cells
[[nodiscard]] TetrahedralMesh grid_mesh(const std::array<int, 3>& cells,
                                        const std::function<Vector3(const Vector3&)>& place, Seam seam = Seam::open);

}  // namespace idiophone::proxies
