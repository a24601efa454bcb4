#pragma once
// Boxes of cells.

#include <algorithm>
#include <array>
#include <cstddef>

namespace idiophone::waves {

/// The cells from `from` to before `to` along each axis.
struct CellBox {
  std::array<int, 3> from{}, to{};

  [[nodiscard]] int width(std::size_t axis) const { return to.at(axis) - from.at(axis); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(width(0)) * width(1) * width(2); }
  [[nodiscard]] bool is_empty() const { return size() == 0; }
  [[nodiscard]] bool contains(const std::array<int, 3>& cell) const {
    return cell[0] >= from[0] && cell[0] < to[0] && cell[1] >= from[1] && cell[1] < to[1] && cell[2] >= from[2] &&
           cell[2] < to[2];
  }

  /// The number of a cell in the box: along x first, then along y, then along z.
  [[nodiscard]] std::size_t place(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2] - from[2]) * width(1) + (cell[1] - from[1])) * width(0) +
           (cell[0] - from[0]);
  }
  /// The cell with this number.
  [[nodiscard]] std::array<int, 3> cell(std::size_t place) const {
    const auto in_row = static_cast<std::size_t>(width(0)), in_column = static_cast<std::size_t>(width(1));
    return {from[0] + static_cast<int>(place % in_row), from[1] + static_cast<int>(place / in_row % in_column),
            from[2] + static_cast<int>(place / in_row / in_column)};
  }

  /// With so many more cells at both ends of each axis.
  [[nodiscard]] CellBox grown(int cells) const {
    CellBox box = *this;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.from.at(axis) -= cells;
      box.to.at(axis) += cells;
    }
    return box;
  }
};

/// The cells that two boxes have in common; an empty box if there are none.
[[nodiscard]] inline CellBox common(const CellBox& a, const CellBox& b) {
  CellBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.from.at(axis) = std::max(a.from.at(axis), b.from.at(axis));
    box.to.at(axis) = std::max(box.from.at(axis), std::min(a.to.at(axis), b.to.at(axis)));
  }
  return box;
}

/// Calls visit(cell) for the cells of a box, in the order of their numbers.
template <class Visit>
void for_each_cell(const CellBox& box, const Visit& visit) {
  for (int z = box.from[2]; z < box.to[2]; ++z) {
    for (int y = box.from[1]; y < box.to[1]; ++y) {
      for (int x = box.from[0]; x < box.to[0]; ++x) {
        visit(std::array{x, y, z});
      }
    }
  }
}

}  // namespace idiophone::waves
