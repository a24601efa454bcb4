#pragma once
// Surfaces in pieces so small that each is in front of one node.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "idiophone/air/waves/cut_cells.hpp"
#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/subdomain.hpp"

namespace idiophone::waves {

/// A part of a triangle.
struct SurfacePiece {
  Vector3 centre;                   ///< from the grid's corner, in cells
  std::array<double, 3> weights{};  ///< of the triangle's corners in the centre; they add up to 1
  Vector3 normal;                   ///< unit vector into the air
  double area = 0.0;                ///< m2
};

/// The node in front of a piece; -1 for none.
[[nodiscard]] Index node_in_front(const CutCells& cut_cells, const SurfacePiece& piece);

/// Divides a triangle into equal pieces, about a quarter of a cell long. None of a triangle that is farther than a
/// cell from the subdomain.
/// @param visit  visit(const SurfacePiece&)
template <class Visit>
void for_each_piece(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle, const Visit& visit) {
  constexpr double piece_length = 0.25;  // in cells
  const Grid& grid = subdomain.grid();
  const Vector3 a = grid.in_cells(obstruction.corner(triangle, 0));
  const Vector3 b = grid.in_cells(obstruction.corner(triangle, 1));
  const Vector3 c = grid.in_cells(obstruction.corner(triangle, 2));
  const CellBox near = subdomain.cells().grown(1);
  const Vector3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (high[axis] < near.from.at(axis) || low[axis] > near.to.at(axis)) {
      return;
    }
  }
  const Vector3 twice_area = (b - a).cross(c - a);
  const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const int n = std::max(1, static_cast<int>(std::ceil(longest / piece_length)));
  SurfacePiece piece{.centre = a,
                     .weights = {},
                     .normal = twice_area.normalized(),
                     .area = 0.5 * twice_area.norm() * grid.cell * grid.cell / (n * n)};
  const auto visit_at = [&](double u, double v) {
    piece.centre = a + u / n * (b - a) + v / n * (c - a);
    piece.weights = {1.0 - (u + v) / n, u / n, v / n};
    visit(std::as_const(piece));
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      visit_at(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j < n - 1) {
        visit_at(i + 2.0 / 3.0, j + 2.0 / 3.0);
      }
    }
  }
}

/// The pieces of a triangle that are in front of nodes of this rank.
/// @param visit  visit(Index node, const SurfacePiece&)
template <class Visit>
void for_each_front(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle,
                    const CutCells& cut_cells, const Visit& visit) {
  for_each_piece(subdomain, obstruction, triangle, [&](const SurfacePiece& piece) {
    const Index node = node_in_front(cut_cells, piece);
    if (node >= 0 && node < cut_cells.own_nodes()) {
      visit(node, piece);
    }
  });
}

}  // namespace idiophone::waves
