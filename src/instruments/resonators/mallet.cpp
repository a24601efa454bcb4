#include "idiophone/instruments/resonators/mallet.hpp"

namespace idiophone::resonators {

Mallet::Mallet(const score::Hammer& hammer, double loss, int rate)
    : ElasticContact({.hardness = hammer.hardness, .loss = loss}, {.points = {{.time = 0.0, .value = 0.0}}},
                     {.mass = hammer.mass, .speed = hammer.speed}, rate) {}

bool Mallet::is_over() const {
  return speed() < 0.0 && approach() < -5.0 * deepest();
}

}  // namespace idiophone::resonators
