#include "idiophone/instruments/sound_maps/air_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/solids/joints/exposed_surface.hpp"

namespace idiophone::sound_maps {

harmonic::DryModes dry_modes(const SoundMap& map) {
  harmonic::DryModes dry{.nodes = map.vertices,
                         .triangles = map.triangles,
                         .shapes = {},
                         .frequencies = map.frequency,
                         .decays = map.material_decay};
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    const auto shape = map.shape_of(mode);
    dry.shapes.emplace_back(shape.begin(), shape.end());
  }
  return dry;
}

std::size_t add_air_mass(SoundMap& map) {
  if (!joints::is_closed(map.triangles)) {
    throw std::runtime_error(
        fmt::format("--in-air needs a closed surface, and that of {} and the bodies joined to it is open where their "
                    "meshes do not meet vertex by vertex: leave it out, or make the meshes match",
                    map.body));
  }
  const harmonic::DryModes dry = dry_modes(map);
  const auto wet = harmonic::wet_modes(dry, {.density = map.air_density, .speed = map.air_speed});
  for (std::size_t mode = 0; mode < wet.size(); ++mode) {
    map.frequency[mode] = wet[mode].frequency;
    map.material_decay[mode] = wet[mode].decay;
    const std::vector<double> shape = harmonic::mixed(wet[mode], dry.shapes);
    std::ranges::transform(shape, map.shape.begin() + static_cast<std::ptrdiff_t>(mode * shape.size()),
                           [](double value) { return static_cast<float>(value); });
  }
  map.scalable.reset();  // the air does not scale with the material
  return wet.size();
}

}  // namespace idiophone::sound_maps
