// Sound maps and proxies of a stage.

#include <Eigen/Geometry>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/proxies/proxy_file.hpp"
#include "idiophone/instruments/sound_maps/voice_file.hpp"
#include "idiophone/instruments/touching/vectors.hpp"

namespace idiophone::engines {

using touching::triple_of;

namespace {

/// With the corners of the box around some points.
BodyFacts with_box(BodyFacts facts, const std::vector<Vector3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points) {
    box.extend(point);
  }
  facts.low = triple_of(box.min());
  facts.high = triple_of(box.max());
  return facts;
}

}  // namespace

SharedMap read_map(const std::filesystem::path& file) {
  return std::make_shared<const sound_maps::SoundMap>(sound_maps::read_voice(file));
}

SharedMap read_map(std::span<const char> bytes, const std::string& name) {
  return std::make_shared<const sound_maps::SoundMap>(sound_maps::read_voice(bytes, name));
}

SharedProxy read_proxy(const std::filesystem::path& file) {
  return std::make_shared<const proxies::StoredBody>(proxies::read_proxy(file));
}

SharedProxy read_proxy(std::span<const char> bytes, const std::string& name) {
  return std::make_shared<const proxies::StoredBody>(proxies::read_proxy(bytes, name));
}

BodyFacts facts_of(const SharedMap& map) {
  BodyFacts facts{.body = map->body, .mass = map->mass, .centre = triple_of(map->centre)};
  if (map->material) {
    facts.young = map->material->young;
    facts.poisson = map->material->poisson;
  }
  return with_box(facts, map->vertices);
}

BodyFacts facts_of(const SharedProxy& proxy) {
  constexpr double of_springs = 0.25;  // proxies::Material
  const proxies::Lattice& finest = *proxy->levels.front();
  return with_box({.body = proxy->name,
                   .mass = finest.body_inertia().mass,
                   .centre = triple_of(finest.body_inertia().centre),
                   .young = finest.material().young,
                   .poisson = of_springs},
                  finest.mesh().nodes);
}

}  // namespace idiophone::engines
