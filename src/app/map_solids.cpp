#include "map_solids.hpp"

#include <spdlog/spdlog.h>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/instruments/sound_maps/rescaled_map.hpp"
#include "idiophone/instruments/sound_maps/solid_map.hpp"
#include "idiophone/instruments/sound_maps/solid_radiation.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "make_map.hpp"
#include "map_warnings.hpp"
#include "other_file.hpp"

namespace idiophone::app {

namespace {

/// The map of a body with its modes, on rank 0.
sound_maps::SoundMap solved_modes(const MapOptions& options, const scene::Scene& scene, std::size_t body) {
  sound_maps::SoundMap map = sound_maps::solid_map(
      scene, body, {.count = options.count.value_or(1), .up_to = highest_frequency(options)}, options.estimates);
  if (const auto left_out = eigenmodes::left_out(map.mesh_error, map.modes(), options.estimates); !left_out.empty()) {
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
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    make(body, [&] { return solved_modes(options, scene, body); });
  }
}

}  // namespace idiophone::app
