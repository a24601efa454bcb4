#include "idiophone/air/harmonic/listener_pressures.hpp"

#include <optional>

#include "idiophone/air/radiation/absorption.hpp"
#include "idiophone/scene/still_receivers.hpp"

namespace idiophone::harmonic {

void place_listeners(Radiation& radiation, std::span<const scene::Listener> listeners) {
  radiation.listener_names.clear();
  radiation.listener_positions.clear();
  for (const scene::StillReceiver& receiver : scene::still_receivers(listeners)) {
    radiation.listener_names.push_back(receiver.name);
    radiation.listener_positions.push_back(receiver.position);
  }
}

std::vector<Complex> pressures_at_listeners(const BoundaryElements& elements, const RadiatedSound& sound,
                                            std::span<const Vector3> positions, const scene::AirProperties& air) {
  const radiation::Atmosphere atmosphere{air.temperature, air.humidity, air.pressure};
  return elements.pressure_at(sound.solution, positions,
                              air.absorption ? atmosphere.attenuation(sound.frequency) : 0.0);
}

void replace_listeners(Radiation& radiation, std::span<const scene::Listener> listeners,
                       const scene::AirProperties& air) {
  place_listeners(radiation, listeners);
  for (std::size_t level = 0; level < radiation.surfaces.size(); ++level) {
    std::optional<BoundaryElements> elements;
    for (RadiatedSound& sound : radiation.sounds) {
      if (sound.refinements == level) {
        if (!elements) {
          elements.emplace(radiation.surfaces[level], radiation.air());
        }
        sound.listener_pressure = pressures_at_listeners(*elements, sound, radiation.listener_positions, air);
      }
    }
  }
}

}  // namespace idiophone::harmonic
