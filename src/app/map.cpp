// `idiophone map`: sound maps of the bodies of a deck.

#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>

#include "command.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/instruments/sound_maps/ideal_deck.hpp"
#include "idiophone/instruments/sound_maps/ideal_map.hpp"
#include "idiophone/instruments/sound_maps/solid_map.hpp"
#include "idiophone/instruments/sound_maps/solid_radiation.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "idiophone/study/measured_maps/measured_map.hpp"
#include "map_outcome.hpp"
#include "map_warnings.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

struct MapOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  double up_to = 20000.0;                                          ///< Hz: all modes up to there
  std::optional<int> count;                                        ///< of modes, the lowest; takes the place of `up_to`
  bool in_air = false;                                             ///< modes with the mass of the air
  std::optional<sound_maps::SurfaceModel> radiation;               ///< empty: as the time allows
  eigenmodes::Estimates estimates = eigenmodes::Estimates::quick;  ///< of the mesh's error
  Style style = Style::text;
};

void declare(CLI::App& app, MapOptions& options) {
  add_deck(app, options.deck, options.overrides);
  CLI::Option* up_to =
      app.add_option("--up-to", options.up_to, "Hz: all modes up to there")->check(CLI::Range(1.0, 1e6));
  up_to->capture_default_str();
  app.add_option("--modes", options.count, "number of modes, the lowest, instead of --up-to")
      ->check(CLI::Range(1, 1000000))
      ->excludes(up_to);
  add_renamed(app, "--count", "--modes");
  app.add_flag("--in-air", options.in_air, "modes with the mass of the air (docs/use/modes.md)");
  using sound_maps::SurfaceModel;
  const deck::Choices<SurfaceModel> models{
      {{"boundary_elements", SurfaceModel::boundary_elements}, {"kirchhoff", SurfaceModel::kirchhoff}}};
  add_choice(app, "--radiation", options.radiation, models,
             "boundary_elements or kirchhoff (default: boundary elements if they take less than two minutes)");
  add_estimates(app, options.estimates);
  add_output_folder(app, options.output, "folder of the maps");
  add_json(app, options.style);
}

constexpr std::size_t rings_of_directions = 16;

/// The modes that are asked for: a number of them, or those up to a frequency.
std::optional<double> highest_frequency(const MapOptions& options) {
  return options.count ? std::nullopt : std::optional(options.up_to);
}

/// Makes a map without its radiation on rank 0. A body without modes is reported, and no reason to stop. Collective.
template <class Modes>
std::optional<sound_maps::SoundMap> find_modes(const std::string& body, const Modes& modes, MapOutcome& outcome,
                                               MPI_Comm communicator) {
  sound_maps::SoundMap map;
  bool has_modes = true;
  parallel::on_root(communicator, [&] {
    try {
      map = modes();
    } catch (const eigenmodes::NoModes& error) {
      spdlog::error("{}: no map. The others are made", error.what());
      outcome.failures.push_back({{"body", body}, {"reason", error.what()}});
      has_modes = false;
    }
  });
  parallel::broadcast(has_modes, communicator);
  return has_modes ? std::optional(std::move(map)) : std::nullopt;
}

/// The name of a body's map, without .h5.
std::string map_name(const scene::Scene& scene, const std::string& body) {
  return scene.name + "_" + body + ".map";
}

std::filesystem::path path_of_map(const MapOptions& options, const std::string& name) {
  return options.output / (name + ".h5");
}

/// Adds the sound of the modes and shows the progress; a signal ends it with the modes that are done.
void add_sound(const MapOptions& options, const scene::Scene& scene, const sound_maps::ModalRadiation& air,
               sound_maps::SoundMap& map, const std::string& body, MapOutcome& outcome, MPI_Comm communicator) {
  WatchedWork radiation("modes of " + body, options.style, communicator);
  sound_maps::add_radiation(map, scene, air, communicator, radiation.watch());
  radiation.note_left_out(outcome.stopped);
}

/// Writes the map of one body. After a signal, it leaves it out.
/// @param modes      makes the map without its radiation, on rank 0
/// @param radiation  makes the air at its surface, and names its model in the map
template <class Modes, class Radiation>
void make_map(const MapOptions& options, const scene::Scene& scene, const std::string& body, const Modes& modes,
              const Radiation& radiation, MapOutcome& outcome, MPI_Comm communicator) {
  if (is_stopped(communicator)) {
    outcome.stopped.push_back("all modes of " + body);
    return;
  }
  const std::string name = map_name(scene, body);
  const loop::OutputLock lock(options.output, name, communicator);
  std::optional<sound_maps::SoundMap> found = find_modes(body, modes, outcome, communicator);
  if (!found) {
    return;
  }
  sound_maps::SoundMap& map = *found;
  parallel::on_root(communicator, [&] {
    map.code_version = program_version;
    map.sphere = sound_maps::sphere_of_directions(rings_of_directions);
    check_map_placement(scene, map);
  });
  sound_maps::share_vibrations(map, communicator);
  add_sound(options, scene, radiation(map), map, body, outcome, communicator);
  parallel::on_root(communicator, [&] { write_map(path_of_map(options, name), map, options.style, outcome); });
}

void map_solids(const MapOptions& options, MapOutcome& outcome, MPI_Comm communicator) {
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, communicator);
  if (parallel::is_root(communicator)) {
    warn_of_what_maps_lack(scene);
  }
  if (options.in_air) {
    refuse_air_mass_of_large_amplitudes(scene);
  }
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    make_map(
        options, scene, scene.bodies[body].name,
        [&] {
          sound_maps::SoundMap map = sound_maps::solid_map(
              scene, body, {.count = options.count.value_or(1), .up_to = highest_frequency(options)},
              options.estimates);
          if (const auto left_out = eigenmodes::left_out(map.mesh_error, map.modes(), options.estimates);
              !left_out.empty()) {
            spdlog::info("body {}: {}", map.body, left_out);
          }
          map.resolved_deck = scene::resolved_deck(options.deck, options.overrides);
          take_air_mass(map, options.in_air);
          return map;
        },
        [&](sound_maps::SoundMap& map) {
          const auto air = sound_maps::solid_radiation(map, scene.radiation, options.radiation);
          map.radiation = air.name + (options.in_air ? ", modes with the mass of the air" : "");
          if (!air.doubt.empty() && parallel::is_root(communicator)) {
            spdlog::warn("body {}: {}", map.body, air.doubt);
          }
          return air.radiation;
        },
        outcome, communicator);
  }
}

void map_ideal_bodies(const MapOptions& options, MapOutcome& outcome, MPI_Comm communicator) {
  sound_maps::IdealDeck deck;
  parallel::on_root(communicator, [&] { deck = sound_maps::read_ideal_deck(options.deck, options.overrides); });
  deck = parallel::is_root(communicator) ? deck : sound_maps::read_ideal_deck(options.deck, options.overrides);
  if (parallel::is_root(communicator)) {
    warn_of_what_maps_lack(deck.scene);
  }
  for (const sound_maps::IdealBody& body : deck.bodies) {
    make_map(
        options, deck.scene, body.name,
        [&] {
          sound_maps::SoundMap map =
              sound_maps::ideal_map(deck.scene, body, options.count.value_or(1), highest_frequency(options));
          map.resolved_deck = sound_maps::resolved_ideal_deck(options.deck, options.overrides);
          return map;
        },
        [](sound_maps::SoundMap& /*map*/) { return sound_maps::rigid_wall(); }, outcome, communicator);
  }
}

/// What is for solids alone.
void refuse_solids_options(const MapOptions& options) {
  if (options.in_air) {
    throw std::runtime_error("--in-air is for solids: ideal bodies are in a rigid wall, and recordings have their air");
  }
  if (options.estimates == eigenmodes::Estimates::all) {
    throw std::runtime_error("--estimate is for solids: ideal bodies and recordings have no mesh");
  }
}

/// What can't be asked of recordings.
void refuse_radiation(const MapOptions& options) {
  if (options.radiation) {
    throw std::runtime_error("--radiation has no meaning for measured bodies: the recordings have their pressures");
  }
}

/// On rank 0 alone.
void map_measured_bodies(const MapOptions& options, MapOutcome& outcome, MPI_Comm communicator) {
  measured_maps::MeasuredDeck deck;
  parallel::on_root(communicator, [&] {
    refuse_radiation(options);
    deck = measured_maps::read_measured_deck(options.deck, options.overrides);
  });
  deck = parallel::is_root(communicator) ? deck : measured_maps::read_measured_deck(options.deck, options.overrides);
  for (const measured_maps::MeasuredBody& body : deck.bodies) {
    const std::string name = map_name(deck.scene, body.name);
    const loop::OutputLock lock(options.output, name, communicator);
    parallel::on_root(communicator, [&] {
      sound_maps::SoundMap map = measured_maps::measured_map(deck, body, {options.up_to, options.count});
      map.code_version = program_version;
      write_map(path_of_map(options, name), map, options.style, outcome);
    });
  }
}

/// How a deck describes its bodies.
enum class MapDeck { solids, ideal_bodies, measured_bodies };

MapDeck kind_of_deck(const MapOptions& options) {
  if (sound_maps::has_ideal_bodies(options.deck, options.overrides)) {
    return MapDeck::ideal_bodies;
  }
  return measured_maps::has_measured_bodies(options.deck, options.overrides) ? MapDeck::measured_bodies
                                                                             : MapDeck::solids;
}

int map(const MapOptions& options) {
  MapDeck kind = MapDeck::solids;
  parallel::on_root(MPI_COMM_WORLD, [&] {
    kind = kind_of_deck(options);
    if (kind != MapDeck::solids) {
      refuse_solids_options(options);
    }
  });
  parallel::broadcast(kind, MPI_COMM_WORLD);
  MapOutcome outcome;
  switch (kind) {
    case MapDeck::solids:
      map_solids(options, outcome, MPI_COMM_WORLD);
      break;
    case MapDeck::ideal_bodies:
      map_ideal_bodies(options, outcome, MPI_COMM_WORLD);
      break;
    case MapDeck::measured_bodies:
      map_measured_bodies(options, outcome, MPI_COMM_WORLD);
  }
  int status = parallel::is_root(MPI_COMM_WORLD) ? report_maps(outcome, options.style) : loop::exit_finished;
  parallel::broadcast(status, MPI_COMM_WORLD);
  return status;
}

}  // namespace

Command map_command() {
  return make_command<MapOptions>("map", "make sound maps of bodies: all that the sound of a blow needs", Ranks::any,
                                  declare, map);
}

}  // namespace idiophone::app
