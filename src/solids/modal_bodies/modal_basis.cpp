#include "idiophone/solids/modal_bodies/modal_basis.hpp"

#include <algorithm>
#include <numbers>

namespace idiophone::modal_bodies {

double residual_frequency(const ModalBasis& basis) {
  constexpr double highest_audible = 20000.0;  // Hz
  const std::size_t own = basis.modes() - basis.further;
  const double highest = own == 0 ? 0.0 : basis.frequencies[own - 1];
  // Each step of a body that stretches is expensive.
  const double least = (basis.stretching.exists() ? 1 : 2) * 2 * std::numbers::pi * highest_audible;
  return std::max(2 * highest, least);
}

}  // namespace idiophone::modal_bodies
