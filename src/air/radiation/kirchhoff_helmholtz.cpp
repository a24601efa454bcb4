#include <numbers>

#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::radiation {

void KirchhoffHelmholtz::radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const {
  const std::size_t count = emission.surface_pressure.size();
  arrivals.sound.resize(count);
  arrivals.change.resize(count);
  arrivals.delay = paths.delay;
  constexpr double scale = 1.0 / (4.0 * std::numbers::pi);
  for (std::size_t first = 0; first < count; first += lane_count) {
    const Lanes4 distance = load(&paths.distance[first]);
    const Lanes4 spread = scale * load(&emission.area[first]) * load(&paths.gain[first]) / distance;
    const Lanes4 dipole = load(&paths.cosine[first]) * load(&emission.surface_pressure[first]);
    put(spread * (dipole / distance - load(&emission.pressure_gradient[first])), &arrivals.sound[first]);
    put(spread * air_.samples_per_metre() * dipole, &arrivals.change[first]);
  }
}

}  // namespace idiophone::radiation
