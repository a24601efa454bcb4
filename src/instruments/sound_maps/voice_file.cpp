#include "idiophone/instruments/sound_maps/voice_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/foundation/flat_file.hpp"
#include "sound_map_paths.hpp"

namespace idiophone::sound_maps {

namespace {

constexpr FlatKind voice_kind{
    .magic = "IDIOPHONE VOICE\n", .version = 1, .made_with = "idiophone export MAP.map.h5 --voice FILE.voice"};
constexpr std::size_t most_listeners = 64;

template <class Archive>
void all_of_material(Archive& archive, std::optional<MapMaterial>& material) {
  std::uint32_t is_known = material ? 1 : 0;
  archive.number(is_known);
  if (is_known != 0) {
    MapMaterial& known = material ? *material : material.emplace();
    archive.text(known.name);
    archive.number(known.density);
    archive.number(known.young);
    archive.number(known.poisson);
  }
}

template <class Archive>
void all_of_listeners(Archive& archive, std::vector<MapListener>& listeners) {
  const std::size_t count = archive.count(listeners.size(), 1);
  if (count > most_listeners) {
    throw std::runtime_error(fmt::format("it has {} listeners, more than {}", count, most_listeners));
  }
  listeners.resize(count);
  for (MapListener& listener : listeners) {
    archive.text(listener.name);
    each_number(archive, listener.position);
    archive.number(listener.delay);
    each_value(archive, listener.pressure);
  }
}

template <class Archive>
void all_of_sphere(Archive& archive, MapSphere& sphere) {
  std::uint64_t rings = sphere.rings, azimuths = sphere.azimuths;
  archive.number(sphere.distance);
  archive.number(rings);
  archive.number(azimuths);
  sphere.rings = rings;
  sphere.azimuths = azimuths;
  each_value(archive, sphere.direction);
  each_value(archive, sphere.weight);
  each_value(archive, sphere.pressure);
}

/// The one order of all that the file has, for writing and reading.
template <class Archive>
void all_of(Archive& archive, SoundMap& map) {
  for (std::string* text : {&map.name, &map.body, &map.kind, &map.code_version, &map.radiation}) {
    archive.text(*text);
  }
  all_of_material(archive, map.material);
  archive.number(map.mass);
  each_number(archive, map.centre);
  archive.number(map.air_density);
  archive.number(map.air_speed);
  for (std::vector<double>* values : {&map.frequency, &map.material_decay, &map.radiation_decay, &map.stretching.linear,
                                      &map.stretching.quadratic, &map.stretching.rotation}) {
    each_value(archive, *values);
  }
  each_value(archive, map.vertices);
  each_value(archive, map.triangles);
  each_value(archive, map.shape);
  all_of_listeners(archive, map.listeners);
  all_of_sphere(archive, map.sphere);
}

SoundMap read_contents(std::span<const char> bytes) {
  ByteReader reader = flat_contents(voice_kind, bytes);
  SoundMap map;
  all_of(reader, map);
  reader.end();
  return map;
}

}  // namespace

std::string voice_file(const SoundMap& map) {
  check_sound_map(map, map.body + ".voice");
  SoundMap copy = map;  // an archive takes what it could change
  ByteWriter contents;
  all_of(contents, copy);
  return flat_file(voice_kind, contents);
}

SoundMap read_voice(std::span<const char> bytes, const std::string& name) {
  SoundMap map;
  try {
    map = read_contents(bytes);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{} is no voice file that can be read: {}", name, error.what()));
  }
  check_sound_map(map, name);
  return map;
}

SoundMap read_voice(const std::filesystem::path& path) {
  return read_voice(read_bytes(path), path.string());
}

}  // namespace idiophone::sound_maps
