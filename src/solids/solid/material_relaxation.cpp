#include "idiophone/solids/solid/material_relaxation.hpp"

#include <fmt/format.h>

namespace idiophone::solid {

Relaxation relaxation_of_loss(const scene::Damping& damping) {
  return damping.loss ? fit_relaxation(*damping.loss) : Relaxation{};
}

Relaxation relaxation_of(const scene::Damping& damping) {
  Relaxation loss = relaxation_of_loss(damping);
  const double creep = damping.of_vibration();
  if (creep == 0.0) {
    return loss;
  }
  for (const Relaxation::Mechanism& mechanism : loss.mechanisms) {
    if (mechanism.rate < 2 * creep) {
      throw deck::DeckError(
          damping.loss->where,
          fmt::format(
              "with mass_of: vibration, the damping `mass` must be below half the rate of the slowest mechanism "
              "of the loss factor, {:.4g} 1/s; it is {:.4g} 1/s. Give the loss factor a higher band",
              mechanism.rate, creep));
    }
  }
  return creeping(loss, creep);
}

}  // namespace idiophone::solid
