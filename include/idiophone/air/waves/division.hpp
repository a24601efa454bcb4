#pragma once
// How ranks share a grid.

#include <cstddef>
#include <vector>

#include "idiophone/air/waves/subdomain.hpp"

namespace idiophone::waves {

/// What a rank has in common with a neighbour.
struct Face {
  int neighbour;        ///< its rank
  std::size_t axis;     ///< it lies across
  int direction;        ///< -1: at the lower side of the rank's cells, 1: at the upper
  CellBox ghost_cells;  ///< cells of the neighbour
};

/// A subdomain for each rank. The ranks are divided in two halves again and again, and their box of cells in the same
/// proportion, across the axis that costs least.
class Division {
 public:
  /// @throws std::runtime_error if there are more ranks than pieces of rows
  Division(const Grid& grid, int ranks);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] int ranks() const { return static_cast<int>(boxes_.size()); }
  /// The cells of a rank.
  [[nodiscard]] const CellBox& cells(int rank) const { return boxes_[rank]; }
  /// The faces between a rank and its neighbours, one for each neighbour: by ascending axis, the lower side first, by
  /// ascending neighbour.
  [[nodiscard]] std::vector<Face> faces(int rank) const;
  /// @throws std::runtime_error as Subdomain
  [[nodiscard]] Subdomain subdomain(int rank) const { return {grid_, boxes_[rank]}; }

 private:
  void divide(const CellBox& box, int ranks);

  Grid grid_;
  std::vector<CellBox> boxes_;  // [ranks]
};

}  // namespace idiophone::waves
