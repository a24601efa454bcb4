#include <numbers>

#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::radiation {

void Kirchhoff::radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const {
  const std::size_t count = emission.pressure.size();
  arrivals.sound.resize(count);
  arrivals.change.resize(count);
  arrivals.delay = paths.delay;
  constexpr double scale = 1.0 / (4.0 * std::numbers::pi);
  for (std::size_t first = 0; first < count; first += wide_count) {
    const WideLanes reciprocal = 1.0 / load<WideLanes>(&paths.distance[first]);
    const WideLanes spread =
        scale * load<WideLanes>(&emission.area[first]) * load<WideLanes>(&paths.gain[first]) * reciprocal;
    const WideLanes dipole = load<WideLanes>(&paths.cosine[first]) * load<WideLanes>(&emission.surface_pressure[first]);
    put(spread * dipole * reciprocal, &arrivals.sound[first]);
    // rho v' = P'/c, and the derivative is with respect to the time of arrival in audio samples.
    put(spread * air_.samples_per_metre() * (load<WideLanes>(&emission.pressure[first]) + dipole),
        &arrivals.change[first]);
  }
}

}  // namespace idiophone::radiation
