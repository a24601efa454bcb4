#include "idiophone/solids/modal_bodies/modal_basis.hpp"

#include <algorithm>
#include <numbers>

namespace idiophone::modal_bodies {

double residual_frequency(const ModalBasis& basis) {
  constexpr double highest_audible = 20000.0;  // Hz
  const std::size_t own = basis.modes() - basis.further;
  const double highest = own == 0 ? 0.0 : basis.frequencies[own - 1];
  return 2 * std::max(highest, 2 * std::numbers::pi * highest_audible);
}

}  // namespace idiophone::modal_bodies
