#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::radiation {

void Huygens::radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const {
  const std::size_t count = emission.pressure.size();
  arrivals.sound.resize(count);
  arrivals.change.clear();
  arrivals.delay = paths.delay;
  const Lanes4 nothing{};
  for (std::size_t first = 0; first < count; first += lane_count) {
    const Lanes4 cosine = load(&paths.cosine[first]);
    const Lanes4 facing = cosine < nothing ? nothing : cosine;  // NaN fails the comparison and is kept
    const Lanes4 strength = load(&emission.pressure[first]) * load(&emission.area[first]) * load(&paths.gain[first]);
    put(strength * facing / load(&paths.distance[first]), &arrivals.sound[first]);
  }
}

}  // namespace idiophone::radiation
