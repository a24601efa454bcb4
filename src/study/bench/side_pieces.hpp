#pragma once
// The small pieces of a side over which the depth of a cut is summed.

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/study/bench/cut_side.hpp"

namespace idiophone::bench {

/// A piece of a side, and how the nodes around it share what is there.
struct SidePiece {
  std::array<double, 2> ends;      ///< m, along the side, ascending
  double area = 0.0;               ///< m2, as it is seen from the side
  std::span<const Index> nodes;    ///< of its face
  std::span<const double> shares;  ///< [nodes] shape functions in its middle; their sum is 1
};

/// Cuts all faces of a side into pieces. Hexahedra have their own shape functions, so that a polynomial of their order
/// is as it is. Tetrahedra have linear ones of their straight triangles, because quadratic ones give corners nothing.
/// @param faces  triangles of the side
void for_each_piece(const mesh::Mesh& mesh, const std::vector<mesh::Triangle>& faces, const Side& side,
                    const std::function<void(const SidePiece&)>& visit);

}  // namespace idiophone::bench
