#pragma once
// Rows of an archive for what lies in cells.

#include <mpi.h>

#include <array>
#include <vector>

#include "idiophone/air/waves/grid.hpp"
#include "idiophone/foundation/parallel/rows.hpp"

namespace idiophone::waves {

/// One row for each of these things, in the order of the cells of the whole grid, whatever the division. Collective.
/// @param cells  [things] in ascending order; other ranks have nothing in the same cells
[[nodiscard]] parallel::Rows rows_by_cell(const Grid& grid, const std::vector<std::array<int, 3>>& cells,
                                          MPI_Comm communicator);

}  // namespace idiophone::waves
