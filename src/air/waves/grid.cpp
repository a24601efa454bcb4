#include "idiophone/air/waves/grid.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace idiophone::waves {

Slab::Slab(const Grid& grid, int begin, int end) : grid_(grid), begin_(begin), end_(end) {
  const double length =
      static_cast<double>(grid.cells[0] + Grid::row_multiple) * (grid.cells[1] + 2) * (end - begin + 3);
  if (length > static_cast<double>(std::numeric_limits<Index>::max())) {
    throw std::runtime_error(fmt::format(
        "waves: {:.3g} cells are too many for one rank; use larger cells (radiation.cell) or more ranks", length));
  }
}

Slab Slab::of_rank(const Grid& grid, int rank, int ranks) {
  const int planes = grid.cells[2];
  if (ranks > planes) {
    throw std::runtime_error(
        fmt::format("waves: a grid of {} planes cannot be shared by {} ranks; use fewer ranks", planes, ranks));
  }
  const auto first = [&](int r) { return static_cast<int>(static_cast<long>(planes) * r / ranks); };
  return {grid, first(rank), first(rank + 1)};
}

}  // namespace idiophone::waves
