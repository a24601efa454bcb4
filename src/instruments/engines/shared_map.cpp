// Sound maps of a stage.

#include <algorithm>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/sound_maps/voice_file.hpp"

namespace idiophone::engines {

SharedMap read_map(const std::filesystem::path& file) {
  return std::make_shared<const sound_maps::SoundMap>(sound_maps::read_voice(file));
}

SharedMap read_map(std::span<const char> bytes, const std::string& name) {
  return std::make_shared<const sound_maps::SoundMap>(sound_maps::read_voice(bytes, name));
}

MapFacts facts_of(const SharedMap& map) {
  Vector3 low = map->vertices.front(), high = low;
  for (const Vector3& vertex : map->vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const auto triple = [](const Vector3& v) { return Triple{v[0], v[1], v[2]}; };
  MapFacts facts{
      .body = map->body, .mass = map->mass, .centre = triple(map->centre), .low = triple(low), .high = triple(high)};
  if (map->material) {
    facts.young = map->material->young;
    facts.poisson = map->material->poisson;
  }
  return facts;
}

}  // namespace idiophone::engines
