#include <numbers>

#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::radiation {

void Rayleigh::radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const {
  const std::size_t count = emission.pressure.size();
  arrivals.sound.assign(count, 0.0);
  arrivals.change.resize(count);
  arrivals.delay = paths.delay;
  // rho v' = P'/c, and the derivative is with respect to the time of arrival in audio samples.
  const double scale = air_.samples_per_metre() / (2.0 * std::numbers::pi);
  const Lanes4 nothing{};
  for (std::size_t first = 0; first < count; first += lane_count) {
    const Lanes4 strength = load(&emission.pressure[first]) * load(&emission.area[first]) * load(&paths.gain[first]);
    const Lanes4 change = scale * strength / load(&paths.distance[first]);
    put(load(&paths.cosine[first]) <= nothing ? nothing : change, &arrivals.change[first]);
  }
}

}  // namespace idiophone::radiation
