#pragma once
// The cells of the air.

#include <array>
#include <cmath>
#include <cstddef>

#include "idiophone/air/waves/cell_box.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::waves {

/// Cubic cells in a box with edges along the axes. The outermost cells are a layer that absorbs sound; the pressure
/// beyond is 0.
struct Grid {
  Vector3 corner = Vector3::Zero();  ///< the lowest one, m
  double cell = 0.004;               ///< edge of a cell, m
  std::array<int, 3> cells{};        ///< along each axis; along x a multiple of row_multiple
  int layer = 0;                     ///< cells across the absorbing layer
  bool rigid_below = false;          ///< instead of a layer, there is a rigid wall at the lowest z

  /// Rows are computed in whole vectors of any instruction set.
  static constexpr int row_multiple = 16;

  [[nodiscard]] CellBox all() const { return {.from = {}, .to = cells}; }
  /// Cells of the absorbing layer at one end of an axis.
  /// @param end  0: the lower, 1: the upper
  [[nodiscard]] int layer_at(std::size_t axis, int end) const {
    return axis == 2 && end == 0 && rigid_below ? 0 : layer;
  }
  /// The cell of a point: coordinates in cells from the corner.
  [[nodiscard]] Vector3 in_cells(const Vector3& point) const { return (point - corner) / cell; }
};

/// The cell that a point is in.
/// @param in_cells  see Grid::in_cells
[[nodiscard]] inline std::array<int, 3> cell_at(const Vector3& in_cells) {
  return {static_cast<int>(std::floor(in_cells[0])), static_cast<int>(std::floor(in_cells[1])),
          static_cast<int>(std::floor(in_cells[2]))};
}

/// A box in units of pieces of rows, of row_multiple cells each: all pieces that have a cell of the box.
[[nodiscard]] inline CellBox row_pieces(CellBox box) {
  box.from[0] /= Grid::row_multiple;
  box.to[0] = (box.to[0] + Grid::row_multiple - 1) / Grid::row_multiple;
  return box;
}

}  // namespace idiophone::waves
