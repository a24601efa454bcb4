#include "idiophone/air/waves/division.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace idiophone::waves {

namespace {

/// What exchanging a cell of a face across each axis costs, in cells that are computed in the same time; estimates, not
/// measured. Cells of a face across x lie apart in memory, and whole pieces of rows are computed before it is sent.
constexpr std::array face_cost = {24.0, 2.0, 2.0};

/// A box cut in two across an axis.
struct Halves {
  CellBox lower, upper;
  double cost = std::numeric_limits<double>::max();
};

/// How many cells along an axis always belong to the same rank.
int length_of_piece(std::size_t axis) {
  return axis == 0 ? Grid::row_multiple : 1;
}

/// @param share  of the lower part
Halves cut_across(std::size_t axis, const CellBox& box, double share) {
  const int count = box.width(axis) / length_of_piece(axis);
  const int lower = std::clamp(static_cast<int>(std::lround(share * count)), 1, count - 1);
  Halves cut{box, box};
  cut.lower.to.at(axis) = cut.upper.from.at(axis) = box.from.at(axis) + lower * length_of_piece(axis);
  const auto cells = [](const CellBox& part) { return static_cast<double>(part.size()); };
  const double fullest = std::max(cells(cut.lower) / share, cells(cut.upper) / (1.0 - share));
  cut.cost = fullest + face_cost.at(axis) * cells(box) / box.width(axis);
  return cut;
}

/// The cut that costs least.
Halves best_cut(const CellBox& box, double share) {
  Halves best;
  for (const std::size_t axis : {2, 1, 0}) {
    if (box.width(axis) > length_of_piece(axis)) {
      const Halves cut = cut_across(axis, box, share);
      best = cut.cost < best.cost ? cut : best;
    }
  }
  return best;
}

int pieces(const CellBox& box) {
  return static_cast<int>(row_pieces(box).size());
}

}  // namespace

Division::Division(const Grid& grid, int ranks) : grid_(grid) {
  if (ranks > pieces(grid.all())) {
    throw std::runtime_error(fmt::format(
        "waves: {} x {} x {} cells cannot be shared by {} ranks, as each needs {} cells along x; use at most {} ranks",
        grid.cells[0], grid.cells[1], grid.cells[2], ranks, Grid::row_multiple, pieces(grid.all())));
  }
  divide(grid.all(), ranks);
}

std::vector<Face> Division::faces(int rank) const {
  std::vector<Face> faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int direction : {-1, 1}) {
      CellBox outside = cells(rank);
      outside.from.at(axis) = direction < 0 ? outside.from.at(axis) - 1 : outside.to.at(axis);
      outside.to.at(axis) = outside.from.at(axis) + 1;
      for (int other = 0; other < ranks(); ++other) {
        if (const CellBox ghost_cells = common(outside, cells(other)); !ghost_cells.is_empty()) {
          faces.push_back({other, axis, direction, ghost_cells});
        }
      }
    }
  }
  return faces;
}

void Division::divide(const CellBox& box, int ranks) {
  if (ranks == 1) {
    boxes_.push_back(box);
    return;
  }
  const int half = ranks / 2;
  const Halves cut = best_cut(box, static_cast<double>(half) / ranks);
  // Where there are hardly more pieces of rows than ranks, a half can have too few of them.
  const int lower = std::clamp(half, std::max(1, ranks - pieces(cut.upper)), pieces(cut.lower));
  divide(cut.lower, lower);
  divide(cut.upper, ranks - lower);
}

}  // namespace idiophone::waves
