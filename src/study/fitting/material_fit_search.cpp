// From which start a fit goes on.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "material_fit.hpp"

namespace idiophone::fitting {

/// Fits from the best start. If the lines are then too far away for chance, a few other starts follow, until one of
/// them explains the lines. The best fit counts.
void MaterialFit::search() {
  constexpr std::size_t most_fits = 4;
  std::vector<Start> starts = begin();
  starts.resize(std::min(starts.size(), most_fits));
  fit_from(starts.front());
  if (starts.size() == 1 || is_believable()) {
    return;
  }
  MaterialFit best = *this;
  try {
    for (std::size_t next = 1; next < starts.size() && !best.is_believable(); ++next) {
      try {
        fit_from(starts[next]);
      } catch (const std::runtime_error&) {  // no line has a mode, or the material is hardly stable
        continue;
      }
      if (cost() < best.cost()) {
        best = *this;
      }
    }
  } catch (const Stopped&) {
    take(std::move(best));
    throw;
  }
  take(std::move(best));
}

void MaterialFit::fit_from(const Start& start) {
  keep(start);
  lines_.assign(measured_.begin(), measured_.begin() + static_cast<std::ptrdiff_t>(lines_.size()));
  mesh_errors_.assign(lines_.size(), 0.0);
  solved_.reset();
  refine();
  choose();
  weigh();
  settle();
}

/// Whether right fits may have such residuals by chance.
bool MaterialFit::is_believable() const {
  const auto freedom = static_cast<double>(pairs_.size()) - static_cast<double>(std::ranges::count(chosen_, true));
  return line_residuals(problem(), pairs_, material_).squaredNorm() <= largest_believable(std::max(1.0, freedom));
}

/// Of the assignment of all fitted lines.
double MaterialFit::cost() const {
  return assign(lines_, *model_, material_, options_.tolerance).cost;
}

/// Goes on from another fit of this search.
void MaterialFit::take(MaterialFit other) {
  other.solves_ = solves_;
  *this = std::move(other);
}

}  // namespace idiophone::fitting
