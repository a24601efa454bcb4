#pragma once
// Where sheets along the planes of the grid of waves lie in its cells. In the outermost eighth of a cell, the air on
// one side of a sheet has no room in the cell, and its mass is off (docs/use/waves.md).

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/waves/grid.hpp"
#include "idiophone/run/bodies/preparation.hpp"

namespace idiophone::advice {

/// A part of a body between two faces along a plane of the grid.
struct Sheet {
  std::size_t body = 0;
  int axis = 0;            ///< at right angles to the sheet
  double middle = 0.0;     ///< between its two faces, along the axis, m
  double thickness = 0.0;  ///< m
};

/// The sheets whose two faces are each a twentieth of the surface of the body at least, and that are thinner than 5/8
/// of a cell, the same on all ranks. Collective.
/// @param cell  edge of a cell, m
[[nodiscard]] std::vector<Sheet> sheets_along_planes(const propagation::AudibleSurface& surface, double cell,
                                                     MPI_Comm communicator);

constexpr double least_clearance = 0.125;  ///< with which sheets are accurate, cells

/// d - max(0, t - 1/8)/2 in cells, with the distance d from the middle of a sheet to the nearest plane of the grid, and
/// its thickness t.
[[nodiscard]] double clearance(const Sheet& sheet, const waves::Grid& grid);

/// Why the air beside a body can't be trusted, and what moves its sheet to the middle of a cell: [bodies]; none with
/// other models than waves, beside recorded bodies, and for bodies that leave their place. Collective.
[[nodiscard]] std::vector<std::optional<std::string>> sheet_warnings(const bodies::Preparation& ready,
                                                                     MPI_Comm communicator);

void print(const std::vector<std::optional<std::string>>& sheet_warnings);

}  // namespace idiophone::advice
