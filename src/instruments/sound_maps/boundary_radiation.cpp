// Modes radiate by boundary elements.

#include <memory>
#include <numbers>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/instruments/sound_maps/modal_radiation.hpp"

namespace idiophone::sound_maps {

namespace {

harmonic::BoundaryElements elements_of(const sound_maps::SoundMap& map) {
  return {{.vertices = map.vertices, .triangles = map.triangles}, {.density = map.air_density, .speed = map.air_speed}};
}

double resolved_frequency(const harmonic::BoundaryElements& elements) {
  return elements.air().speed / (harmonic::least_resolution * elements.longest_edge());
}

}  // namespace

ModalRadiation boundary_elements(const sound_maps::SoundMap& map, const scene::Radiation& radiation) {
  const auto elements = std::make_shared<const harmonic::BoundaryElements>(elements_of(map));
  return [elements, above = sphere_patches(map, radiation)](double angular_frequency,
                                                            std::span<const double> normal_velocity) {
    if (angular_frequency > 2.0 * std::numbers::pi * resolved_frequency(*elements)) {
      return above(angular_frequency, normal_velocity);
    }
    const std::vector<std::vector<harmonic::Complex>> velocities = {{normal_velocity.begin(), normal_velocity.end()}};
    const double wave_number = angular_frequency / elements->air().speed;
    return harmonic::triangle_pressures(elements->boundary(), elements->solve(wave_number, velocities).front());
  };
}

double resolved_frequency(const sound_maps::SoundMap& map) {
  return resolved_frequency(elements_of(map));
}

}  // namespace idiophone::sound_maps
