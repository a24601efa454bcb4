#include "map_warnings.hpp"

#include <spdlog/spdlog.h>

#include "idiophone/instruments/sound_maps/air_mass.hpp"
#include "idiophone/instruments/sound_maps/small_vibrations.hpp"
#include "idiophone/scene/body_materials.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/scene/large_amplitudes.hpp"
#include "listener_warnings.hpp"

namespace idiophone::app {

void warn_of_what_maps_lack(const scene::Scene& scene) {
  for (const auto& body : scene.recorded_bodies) {
    spdlog::warn("body {} is a recording: it has no modes and gets no map", body.name);
  }
  for (const auto& body : scene.bodies) {
    if (body.mass_scaling) {
      spdlog::warn(
          "body {}: mass_scaling lowers the pitches of its map by up to {:.3g} cents, as it does in a run. A map has "
          "no steps that it could lengthen: leave it out",
          body.name, body.mass_scaling->shift);
    }
    if (scene::is_undamped(body, scene.materials)) {
      spdlog::warn("body {}: {}", body.name, scene::undamped_in_words);
    }
  }
  if (scene::assemblies(scene).size() + scene.obstacles.size() > 1) {
    spdlog::warn("{} is heard alone: other bodies and obstacles cast no shadow in its map",
                 scene.joints.empty() ? "each body" : "each body, with those that joints tie to it,");
  }
  if (scene.radiation.room) {
    spdlog::warn("a map has no room: the walls of radiation.room are left out");
  }
  warn_of_still_listeners(scene, "the map");
}

void refuse_air_mass_of_large_amplitudes(const scene::Scene& scene) {
  for (const scene::Body& body : scene.bodies) {
    if (scene::has_large_amplitudes(body)) {
      throw std::runtime_error(
          "--in-air is for small vibrations: body " + body.name +
          " has large_amplitudes, which are known without the mass of the air. Leave out one of them");
    }
  }
}

void warn_of_small_vibrations(const sound_maps::SoundMap& map, const std::string& what) {
  if (map.stretching.exists()) {
    spdlog::warn("body {}: {} {}", map.body, what, sound_maps::without_large_amplitudes);
  }
}

void check_map_placement(const scene::Scene& scene, const sound_maps::SoundMap& map) {
  propagation::Surroundings around;
  around.bodies = 1;
  around.add(map.body, map.vertices, map.triangles);
  check_placement(scene, around, propagation::Hearing::straight_ways);
}

void take_air_mass(sound_maps::SoundMap& map, bool in_air) {
  if (in_air) {
    if (const std::size_t resolved = sound_maps::add_air_mass(map); resolved < map.modes()) {
      spdlog::warn(
          "body {}: {} of {} modes have no mass of the air: their sound has less than three edges of the mesh in a "
          "wavelength",
          map.body, map.modes() - resolved, map.modes());
    }
    return;
  }
  const auto [mode, shift] = harmonic::largest_estimated_shift(sound_maps::dry_modes(map),
                                                               {.density = map.air_density, .speed = map.air_speed});
  if (shift > harmonic::audible_shift) {
    spdlog::warn(
        "body {}: the mass of the air would lower mode {} by about {:.0f} cents; --in-air takes it into account",
        map.body, mode + 1, shift);
  }
}

}  // namespace idiophone::app
