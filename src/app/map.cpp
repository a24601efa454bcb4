// `idiophone map`: sound maps of the bodies of a deck.

#include "command.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/instruments/sound_maps/ideal_deck.hpp"
#include "idiophone/instruments/sound_maps/ideal_map.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/study/measured_maps/measured_map.hpp"
#include "make_map.hpp"
#include "map_options.hpp"
#include "map_outcome.hpp"
#include "map_solids.hpp"
#include "map_warnings.hpp"

namespace idiophone::app {

namespace {

void declare(CLI::App& app, MapOptions& options) {
  add_deck(app, options.deck, options.overrides);
  CLI::Option* up_to =
      app.add_option("--up-to", options.up_to, "Hz: all modes up to there")->check(CLI::Range(1.0, 1e9));
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
  CLI::Option* rescale =
      app.add_option("--rescale", options.rescaled,
                     "NAME_BODY.map.h5: take its modes; density, stiffness and damping of the deck may differ");
  for (const char* other : {"--up-to", "--modes", "--in-air", "--estimate", "--no-estimate"}) {
    rescale->excludes(other);
  }
  add_output_folder(app, options.output, "folder of the maps");
  add_json(app, options.style);
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
  if (!options.rescaled.empty()) {
    throw std::runtime_error("--rescale is for solids: ideal bodies and recordings have no elastic constants to scale");
  }
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
