#pragma once
// What `idiophone map` was asked for.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/instruments/sound_maps/solid_radiation.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "shared_options.hpp"

namespace idiophone::app {

struct MapOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  double up_to = 20000.0;                             ///< Hz: all modes up to there
  std::optional<int> count;                           ///< of modes, the lowest; takes the place of `up_to`
  std::filesystem::path rescaled;                     ///< map whose modes are taken; empty: they are solved
  bool in_air = false;                                ///< modes with the mass of the air
  std::optional<sound_maps::SurfaceModel> radiation;  ///< empty: as the time allows
  eigenmodes::Estimates estimates = eigenmodes::Estimates::quick;  ///< of the mesh's error
  Style style = Style::text;
};

/// The modes that are asked for: those up to a frequency, Hz; empty for a number of them.
[[nodiscard]] inline std::optional<double> highest_frequency(const MapOptions& options) {
  return options.count ? std::nullopt : std::optional(options.up_to);
}

}  // namespace idiophone::app
