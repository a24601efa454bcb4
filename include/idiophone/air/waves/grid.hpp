#pragma once
// The cells of the air, and the planes of them that one rank computes.

#include <array>
#include <cstddef>

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

  /// Cells of the absorbing layer at one end of an axis.
  /// @param end  0: the lower, 1: the upper
  [[nodiscard]] int layer_at(std::size_t axis, int end) const {
    return axis == 2 && end == 0 && rigid_below ? 0 : layer;
  }
  /// The cell of a point: coordinates in cells from the corner.
  [[nodiscard]] Vector3 in_cells(const Vector3& point) const { return (point - corner) / cell; }
};

/// Planes of constant z from `begin` to `end`, with one more plane below and above: those of the neighbours. Arrays
/// hold them with a row of zeros around each plane.
class Slab {
 public:
  /// @throws std::runtime_error if 32 bits cannot number its cells
  Slab(const Grid& grid, int begin, int end);

  /// The planes of one of several ranks.
  /// @throws std::runtime_error if there are more ranks than planes
  [[nodiscard]] static Slab of_rank(const Grid& grid, int rank, int ranks);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] int begin() const { return begin_; }
  [[nodiscard]] int end() const { return end_; }
  [[nodiscard]] bool owns(int z) const { return z >= begin_ && z < end_; }

  /// Numbers from one cell to the next along y, and along z.
  [[nodiscard]] Index row_length() const { return grid_.cells[0] + Grid::row_multiple; }
  [[nodiscard]] Index plane_length() const { return row_length() * (grid_.cells[1] + 2); }
  /// Numbers from one cell to the next along an axis.
  [[nodiscard]] Index stride(std::size_t axis) const {
    return std::array{Index{1}, row_length(), plane_length()}.at(axis);
  }
  /// Length of an array of cells.
  [[nodiscard]] Index length() const { return plane_length() * (end_ - begin_ + 2) + Grid::row_multiple; }
  /// The number of a cell in such an array; z from begin() - 1 to end().
  [[nodiscard]] Index number(int x, int y, int z) const {
    return (z - begin_ + 1) * plane_length() + (y + 1) * row_length() + x + Grid::row_multiple;
  }

 private:
  Grid grid_;
  int begin_, end_;
};

}  // namespace idiophone::waves
