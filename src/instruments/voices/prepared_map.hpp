#pragma once
// A sound map with what all bodies that share it need.

#include <memory>
#include <vector>

#include "idiophone/instruments/sound_maps/surface_search.hpp"

namespace idiophone::voices {

struct PreparedMap {
  explicit PreparedMap(std::shared_ptr<const sound_maps::SoundMap> sound_map);

  std::shared_ptr<const sound_maps::SoundMap> map;
  sound_maps::SurfaceSearch surface;
  double radius = 0.0;  ///< of the farthest vertex from the centre, m
};

/// One for each map, in their order; bodies that share a map share what is made of it.
[[nodiscard]] std::vector<std::shared_ptr<const PreparedMap>> prepared(
    const std::vector<std::shared_ptr<const sound_maps::SoundMap>>& maps);

}  // namespace idiophone::voices
