#include "map_solids.hpp"

#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/instruments/sound_maps/rescaled_map.hpp"
#include "idiophone/instruments/sound_maps/solid_map.hpp"
#include "idiophone/instruments/sound_maps/solid_radiation.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "make_map.hpp"
#include "map_warnings.hpp"
#include "other_file.hpp"

namespace idiophone::app {

namespace {

/// Says which bodies have one map, if they are several.
/// @param bodies  of the map, as scene::assemblies() gives them
void say_joined(const scene::Scene& scene, const std::vector<std::size_t>& bodies) {
  if (bodies.size() > 1) {
    std::vector<std::string> names;
    std::ranges::transform(bodies, std::back_inserter(names),
                           [&](std::size_t body) { return scene.bodies[body].name; });
    spdlog::info("bodies {}: joints tie them together, so they have one map, which is called {}",
                 fmt::join(names, ", "), names.front());
  }
}

/// The map of a body with its modes, and those of all bodies that joints tie to it, on rank 0.
sound_maps::SoundMap solved_modes(const MapOptions& options, const scene::Scene& scene, std::size_t body) {
  const auto estimates = scene::is_joined(body, scene.joints) ? eigenmodes::Estimates::none : options.estimates;
  sound_maps::SoundMap map = sound_maps::solid_map(
      scene, body, {.count = options.count.value_or(1), .up_to = highest_frequency(options)}, estimates);
  if (const auto left_out = eigenmodes::left_out(map.mesh_error, map.modes(), estimates); !left_out.empty()) {
    spdlog::info("body {}: {}", map.body, left_out);
  }
  map.resolved_deck = scene::resolved_deck(options.deck, options.overrides);
  take_air_mass(map, options.in_air);
  return map;
}

/// The same from another map, on rank 0. A wish for a radiation model means that the radiation is computed.
sound_maps::SoundMap rescaled_modes(const MapOptions& options, const scene::Scene& scene, std::size_t body,
                                    const sound_maps::SoundMap& source) {
  require_other_file(path_of_map(options, map_name(scene, source.body)), options.rescaled);
  sound_maps::SoundMap map = sound_maps::rescaled_map(source, options.rescaled, scene, body,
                                                      scene::resolved_deck(options.deck, options.overrides));
  if (options.radiation) {
    map.sphere = {};
  }
  spdlog::info("body {}: the modes are those of {}{}", map.body, options.rescaled.string(),
               map.sphere.pressure.empty() ? "" : ", and so is their radiation");
  take_air_mass(map, false);
  return map;
}

/// Makes the air at the surface of a map, and says why it is not the better model. Collective.
sound_maps::ModalRadiation radiation_of(const MapOptions& options, const scene::Scene& scene, sound_maps::SoundMap& map,
                                        MPI_Comm communicator) {
  const auto air = sound_maps::solid_radiation(map, scene.radiation, options.radiation);
  map.radiation = air.name + (options.in_air ? ", modes with the mass of the air" : "");
  if (!air.doubt.empty() && parallel::is_root(communicator)) {
    spdlog::warn("body {}: {}", map.body, air.doubt);
  }
  return air.radiation;
}

/// The place in the deck of the body that a map belongs to. Collective.
std::size_t body_of(const sound_maps::SoundMap& map, const scene::Scene& scene, MPI_Comm communicator) {
  std::size_t body = 0;
  parallel::on_root(communicator, [&] { body = scene::find_body(scene.bodies, map.body); });
  parallel::broadcast(body, communicator);
  return body;
}

}  // namespace

void map_solids(const MapOptions& options, MapOutcome& outcome, MPI_Comm communicator) {
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, communicator);
  if (parallel::is_root(communicator)) {
    warn_of_what_maps_lack(scene);
  }
  if (options.estimates == eigenmodes::Estimates::all && !scene.joints.empty()) {
    throw std::runtime_error(fmt::format("--estimate is for bodies without joints, and {} has one: leave it out",
                                         scene.bodies[scene.joints.front().surfaces.front().body].name));
  }
  if (options.in_air) {
    refuse_air_mass_of_large_amplitudes(scene);
  }
  const auto make = [&](std::size_t body, const FindModes& modes) {
    make_map(
        options, scene, scene.bodies[body].name, modes,
        [&](sound_maps::SoundMap& map) { return radiation_of(options, scene, map, communicator); }, outcome,
        communicator);
  };
  if (!options.rescaled.empty()) {
    sound_maps::SoundMap source;
    parallel::on_root(communicator, [&] { source = sound_maps::read_sound_map(options.rescaled); });
    const std::size_t body = body_of(source, scene, communicator);
    make(body, [&] { return rescaled_modes(options, scene, body, source); });
    return;
  }
  for (const std::vector<std::size_t>& bodies : scene::assemblies(scene)) {
    const std::size_t body = bodies.front();
    make(body, [&] {
      say_joined(scene, bodies);
      return solved_modes(options, scene, body);
    });
  }
}

}  // namespace idiophone::app
