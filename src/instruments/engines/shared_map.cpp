// Sound maps of a stage.

#include <Eigen/Geometry>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/sound_maps/voice_file.hpp"
#include "idiophone/instruments/touching/vectors.hpp"

namespace idiophone::engines {

using touching::triple_of;

SharedMap read_map(const std::filesystem::path& file) {
  return std::make_shared<const sound_maps::SoundMap>(sound_maps::read_voice(file));
}

SharedMap read_map(std::span<const char> bytes, const std::string& name) {
  return std::make_shared<const sound_maps::SoundMap>(sound_maps::read_voice(bytes, name));
}

MapFacts facts_of(const SharedMap& map) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : map->vertices) {
    box.extend(vertex);
  }
  MapFacts facts{.body = map->body,
                 .mass = map->mass,
                 .centre = triple_of(map->centre),
                 .low = triple_of(box.min()),
                 .high = triple_of(box.max())};
  if (map->material) {
    facts.young = map->material->young;
    facts.poisson = map->material->poisson;
  }
  return facts;
}

}  // namespace idiophone::engines
