#pragma once
// How much wall each node is in front of.

#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"

namespace idiophone::waves {

/// Of the nodes of the slab's own planes; others have none.
[[nodiscard]] std::vector<WallShare> wall_shares(const Slab& slab, const Obstruction& obstruction,
                                                 const CutCells& cut_cells);

}  // namespace idiophone::waves
