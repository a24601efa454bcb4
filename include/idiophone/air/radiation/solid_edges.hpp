#pragma once
// The edges of surfaces made of triangles that sound bends around.

#include <array>
#include <span>
#include <vector>

#include "idiophone/air/radiation/diffracting_edge.hpp"

namespace idiophone::radiation {

/// Where two faces meet along a straight line. At the rim of an open surface, both are the same one.
struct SolidEdge {
  std::array<Index, 2> ends;       ///< vertices
  std::array<Index, 2> triangles;  ///< one of each face, with a side on the edge
};

/// Triangles and where their vertices are.
struct TriangleView {
  std::span<const std::array<Index, 3>> triangles;
  std::span<const float> positions;  ///< [3 x vertices] m
};

/// The edges that stick out by at least 30 degrees, and open rims. Sides of triangles that are in line are one edge.
/// @param first, last  triangles of one body: from, and one past; their corners are around the outward normal
[[nodiscard]] std::vector<SolidEdge> find_solid_edges(const TriangleView& surface, Index first, Index last);

/// An edge where its vertices are now.
[[nodiscard]] DiffractingEdge placed(const SolidEdge& edge, const TriangleView& surface);

}  // namespace idiophone::radiation
