#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

std::string mesh_error_text(const SoundMap& map) {
  constexpr double lowest_audible = 20;  // Hz
  std::size_t audible = 0, known = 0, largest = 0;
  for (std::size_t mode = 0; mode < map.mesh_error.size(); ++mode) {
    // Below are bodies that swing on soft supports, whose patches change with the mesh.
    if (map.frequency[mode] < lowest_audible) {
      continue;
    }
    ++audible;
    if (std::isnan(map.mesh_error[mode])) {
      continue;
    }
    if (known++ == 0 || std::abs(map.mesh_error[mode]) > std::abs(map.mesh_error[largest])) {
      largest = mode;
    }
  }
  if (known == 0) {
    return {};
  }
  return fmt::format(
      "the mesh makes frequencies wrong by up to {:.1f} cents (mode {}), as estimated for {} of {} audible modes",
      std::abs(map.mesh_error[largest]), largest + 1, known, audible);
}

}  // namespace idiophone::sound_maps
