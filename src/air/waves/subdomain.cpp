#include "idiophone/air/waves/subdomain.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace idiophone::waves {

Subdomain::Subdomain(const Grid& grid, const CellBox& cells) : grid_(grid), cells_(cells) {
  const double length =
      static_cast<double>(cells.width(0) + Grid::row_multiple) * (cells.width(1) + 2) * (cells.width(2) + 3);
  if (length > static_cast<double>(std::numeric_limits<Index>::max())) {
    throw std::runtime_error(fmt::format(
        "waves: {:.3g} cells are too many for one rank; use larger cells (radiation.cell) or more ranks", length));
  }
}

}  // namespace idiophone::waves
