#pragma once
// The part of a grid that one rank computes.

#include <array>
#include <cstddef>

#include "idiophone/air/waves/grid.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::waves {

/// A box of cells of whole pieces of rows, and one more cell on each side: the ghost cells, which belong to its
/// neighbours or lie beyond the grid. Arrays hold both.
class Subdomain {
 public:
  /// @throws std::runtime_error if 32 bits cannot number its cells
  Subdomain(const Grid& grid, const CellBox& cells);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  /// Without the ghost cells.
  [[nodiscard]] const CellBox& cells() const { return cells_; }
  /// Whether its lowest ghost cells are the mirror image of the cells above a rigid floor.
  [[nodiscard]] bool is_on_floor() const { return grid_.rigid_below && cells_.from[2] == 0; }
  [[nodiscard]] bool owns(const std::array<int, 3>& cell) const { return cells_.contains(cell); }

  /// Numbers from one cell to the next along an axis.
  [[nodiscard]] Index stride(std::size_t axis) const {
    return std::array{Index{1}, row_length(), plane_length()}.at(axis);
  }
  /// Length of an array of cells.
  [[nodiscard]] Index length() const { return plane_length() * (cells_.width(2) + 2) + Grid::row_multiple; }
  /// The number of a cell or of a ghost cell in such an array.
  [[nodiscard]] Index number(const std::array<int, 3>& cell) const {
    return (cell[2] - cells_.from[2] + 1) * plane_length() + (cell[1] - cells_.from[1] + 1) * row_length() +
           (cell[0] - cells_.from[0]) + Grid::row_multiple;
  }

 private:
  // The ghost cells at both ends of a row are at the ends of one gap between two rows.
  [[nodiscard]] Index row_length() const { return cells_.width(0) + Grid::row_multiple; }
  [[nodiscard]] Index plane_length() const { return row_length() * (cells_.width(1) + 2); }

  Grid grid_;
  CellBox cells_;
};

}  // namespace idiophone::waves
