// From which start a fit goes on.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/random_numbers.hpp"
#include "material_fit.hpp"

namespace idiophone::fitting {

/// Fits from the best start. If the lines are then too far away for chance, a few other starts follow, until one of
/// them explains the lines. The best fit counts.
void MaterialFit::search() {
  constexpr std::size_t most_others = 3;
  const std::vector<Start> starts = begin(turned_starts());
  fit_from(starts.front());
  if (is_believable()) {
    return;
  }
  MaterialFit best = *this;
  try {
    const std::vector<Start> others = other_starts(starts);
    for (std::size_t next = 0; next < std::min(others.size(), most_others) && !best.is_believable(); ++next) {
      try {
        fit_from(others[next]);
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

/// Where the search goes on after a fit that is not believable: from the next of several starts. If there was only one,
/// and the lines are much farther away than less exact lines would be, from other materials.
std::vector<MaterialFit::Start> MaterialFit::other_starts(const std::vector<Start>& starts) {
  constexpr double far = 3.0;  // uncertainties
  if (starts.size() > 1) {
    return {starts.begin() + 1, starts.end()};
  }
  const std::vector<TurnedMaterial> materials = other_materials();
  if (materials.empty() || chi_squared() < far * far * freedom()) {
    return {};
  }
  try {
    return begin(materials);
  } catch (const std::runtime_error&) {  // no line is near a mode, or all of them are hardly stable
    return {};
  }
}

/// Materials drawn from what is expected of the deck's constants; none where only one or two may change, because the
/// search finds these from everywhere.
std::vector<TurnedMaterial> MaterialFit::other_materials() const {
  constexpr int drawn = 12;
  const Eigen::VectorXd may_change = stages_.back().rowwise().sum();
  if (may_change.sum() < 3) {
    return {};
  }
  const Expectation expected = expectation_of(start_);
  NormalNumbers normal;
  std::vector<TurnedMaterial> materials;
  for (int number = 0; number < drawn; ++number) {
    Eigen::VectorXd point = expected.middle;
    for (Eigen::Index k = 0; k < point.size(); ++k) {
      point[k] += may_change[k] * expected.deviation[k] * normal.next();
    }
    const TurnedMaterial material = with_unknowns(constants_, start_, point);
    if (is_stable(material)) {
      materials.push_back(material);
    }
  }
  return materials;
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

double MaterialFit::freedom() const {
  return std::max(1.0, static_cast<double>(pairs_.size()) - static_cast<double>(std::ranges::count(chosen_, true)));
}

double MaterialFit::chi_squared() const {
  return line_residuals(problem(), pairs_, material_).squaredNorm();
}

/// Whether right fits may have such residuals by chance.
bool MaterialFit::is_believable() const {
  return chi_squared() <= largest_believable(freedom());
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
