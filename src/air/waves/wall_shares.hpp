#pragma once
// How much wall each node is in front of.

#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"

namespace idiophone::waves {

/// Of the nodes that are not in ghost cells; others have none.
[[nodiscard]] std::vector<WallShare> wall_shares(const Subdomain& subdomain, const Obstruction& obstruction,
                                                 const CutCells& cut_cells);

}  // namespace idiophone::waves
