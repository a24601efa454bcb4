#pragma once
// Where lines through a grid are inside of solids.

#include <cstddef>
#include <utility>
#include <vector>

#include "idiophone/air/waves/grid.hpp"
#include "idiophone/air/waves/obstruction.hpp"

namespace idiophone::waves {

/// A piece of a line along an axis through the centres of sub-voxels.
struct InnerPiece {
  Index line;          ///< number within the box: counted along the next axis (x after z), then along the one after it
  float from, to;      ///< along the line from the grid's corner, in sub-voxels
  bool through_sheet;  ///< the surfaces at both ends look in opposite directions, within 60 degrees
};

/// The pieces about which surfaces wind, of all lines along an axis through a box of cells.
/// @return by line, then along it
[[nodiscard]] std::vector<InnerPiece> inner_pieces(const Obstruction& obstruction, const Grid& grid, const CellBox& box,
                                                   std::size_t axis);

/// The sub-voxels whose centres lie between two coordinates: numbers from first to before last.
[[nodiscard]] std::pair<int, int> centres(double from, double to);

}  // namespace idiophone::waves
