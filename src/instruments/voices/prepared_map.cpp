#include "prepared_map.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace idiophone::voices {

PreparedMap::PreparedMap(std::shared_ptr<const sound_maps::SoundMap> sound_map)
    : map(std::move(sound_map)), surface(*map) {
  for (const Vector3& vertex : map->vertices) {
    radius = std::max(radius, (vertex - map->centre).norm());
  }
}

std::vector<std::shared_ptr<const PreparedMap>> prepared(
    const std::vector<std::shared_ptr<const sound_maps::SoundMap>>& maps) {
  std::map<const sound_maps::SoundMap*, std::shared_ptr<const PreparedMap>> made;
  std::vector<std::shared_ptr<const PreparedMap>> all;
  for (const auto& map : maps) {
    std::shared_ptr<const PreparedMap>& one = made[map.get()];
    if (!one) {
      one = std::make_shared<const PreparedMap>(map);
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace idiophone::voices
