#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "idiophone/lanes.hpp"
#include "idiophone/radiation/radiation.hpp"

namespace idiophone::radiation {

Huygens::Huygens(const Air& air) : samples_per_metre_(air.samples_per_metre()) {
  if (!(air.speed > 0.0) || !std::isfinite(air.speed) || air.rate < 1) {
    throw std::invalid_argument(
        fmt::format("air: the speed of sound is {} m/s and the audio rate {} per second; both have to be positive",
                    air.speed, air.rate));
  }
}

void Huygens::radiate(const surface::Emission& emission, const Vector3& receiver, Arrivals& arrivals) const {
  const std::size_t count = emission.pressure.size();
  if (count % lane_count != 0) {
    throw std::invalid_argument(fmt::format("Huygens: an emission of {} triangles is not padded", count));
  }
  arrivals.sound.resize(count);
  arrivals.delay.resize(count);
  const Lanes nothing{};
  const Lanes smallest_square = Lanes{} + smallest_distance * smallest_distance;
  for (std::size_t first = 0; first < count; first += lane_count) {
    Lanes square{}, facing{};  // R^2 and R cos(theta)
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes towards = receiver[axis] - load(&emission.centre[axis][first]);
      square += towards * towards;
      facing += towards * load(&emission.normal[axis][first]);
    }
    // Comparisons that NaN fails: it has to pass on and be noticed, not be clipped away.
    square = square < smallest_square ? smallest_square : square;
    facing = facing < nothing ? nothing : facing;
    const Lanes strength = load(&emission.pressure[first]) * load(&emission.area[first]);
    put(strength * facing / square, &arrivals.sound[first]);
    put(square_root(square) * samples_per_metre_, &arrivals.delay[first]);
  }
}

}  // namespace idiophone::radiation
