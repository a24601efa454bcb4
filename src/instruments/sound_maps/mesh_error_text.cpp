#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

std::string mesh_error_text(const SoundMap& map) {
  const auto is_known = [](double error) { return !std::isnan(error); };
  const auto known = std::ranges::count_if(map.mesh_error, is_known);
  if (known == 0) {
    return {};
  }
  const auto size = [&](double error) { return is_known(error) ? std::abs(error) : 0.0; };
  const auto largest = std::ranges::max_element(map.mesh_error, {}, size);
  return fmt::format(
      "the mesh makes frequencies wrong by up to {:.1f} cents (mode {}), as estimated for {} of {} modes",
      std::abs(*largest), largest - map.mesh_error.begin() + 1, known, map.modes());
}

}  // namespace idiophone::sound_maps
