// `idiophone map`: sound maps of the bodies of a deck.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/air/propagation/placement.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/instruments/sound_maps/air_mass.hpp"
#include "idiophone/instruments/sound_maps/ideal_deck.hpp"
#include "idiophone/instruments/sound_maps/ideal_map.hpp"
#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "idiophone/instruments/sound_maps/solid_map.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "idiophone/study/measured_maps/measured_map.hpp"

namespace idiophone::app {

namespace {

/// Who computes the air at the surface of a solid.
enum class MapRadiation { boundary_elements, kirchhoff };

struct MapOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  double up_to = 20000.0;                                          ///< Hz: all modes up to there
  std::optional<int> count;                                        ///< of modes, the lowest; takes the place of `up_to`
  bool in_air = false;                                             ///< modes with the mass of the air
  std::optional<MapRadiation> radiation;                           ///< empty: as the time allows
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
  const deck::Choices<MapRadiation> models{
      {{"boundary_elements", MapRadiation::boundary_elements}, {"kirchhoff", MapRadiation::kirchhoff}}};
  add_choice(app, "--radiation", options.radiation, models,
             "boundary_elements or kirchhoff (default: boundary elements if they take less than two minutes)");
  add_estimates(app, options.estimates);
  add_output_folder(app, options.output, "folder of the maps");
  add_json(app, options.style);
}

constexpr std::size_t rings_of_directions = 16;

/// Boundary elements that take longer on one core have to be asked for, s.
constexpr double longest_time_by_default = 120.0;

/// What of the deck does not reach its maps.
void warn(const scene::Scene& scene) {
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
  }
  if (scene.bodies.size() + scene.obstacles.size() > 1) {
    spdlog::warn("each body is heard alone: other bodies and obstacles cast no shadow in its map");
  }
  if (scene.radiation.room) {
    spdlog::warn("a map has no room: the walls of radiation.room are left out");
  }
  for (const auto& listener : scene.listeners) {
    if (listener.path) {
      spdlog::warn("listener {} moves: the map has its place at time 0", listener.name);
    }
    if (listener.head) {
      spdlog::warn("listener {} has a head: the map has the pressure at its centre, without the head", listener.name);
    }
  }
}

/// @throws deck::DeckError where listeners or the body are where they can't be
void check_placement(const scene::Scene& scene, const sound_maps::SoundMap& map) {
  propagation::Surroundings around;
  around.bodies = 1;
  around.add(map.body, map.vertices, map.triangles);
  for (const auto& warning : propagation::placement_warnings(scene, around, propagation::Hearing::straight_ways)) {
    spdlog::warn(warning);
  }
}

nlohmann::json map_facts(const sound_maps::SoundMap& map, const std::filesystem::path& path) {
  auto errors = nlohmann::json::array();
  std::ranges::transform(map.mesh_error, std::back_inserter(errors), loop::number_or_null);
  return {{"file", path.string()},
          {"body", map.body},
          {"modes", map.modes()},
          {"lowest_frequency", map.frequency.front()},
          {"highest_frequency", map.frequency.back()},
          {"frequencies", map.frequency},
          {"mesh_errors", errors},
          {"vertices", map.vertices.size()},
          {"triangles", map.triangles.size()},
          {"listeners", map.listeners.size()},
          {"directions", map.sphere.direction.size()},
          {"radiation", map.radiation}};
}

void report(const sound_maps::SoundMap& map, const std::filesystem::path& path) {
  spdlog::info("{}: body {}, {} modes from {:.6g} to {:.6g} Hz, {} vertices, {} triangles, {} listeners, {} directions",
               path.string(), map.body, map.modes(), map.frequency.front(), map.frequency.back(), map.vertices.size(),
               map.triangles.size(), map.listeners.size(), map.sphere.direction.size());
  if (const std::string errors = sound_maps::mesh_error_text(map); !errors.empty()) {
    spdlog::info("body {}: {}", map.body, errors);
  }
}

/// The modes that are asked for: a number of them, or those up to a frequency.
std::optional<double> highest_frequency(const MapOptions& options) {
  return options.count ? std::nullopt : std::optional(options.up_to);
}

/// About what boundary elements take on one core for the modes that the mesh resolves, s.
double boundary_element_time(const sound_maps::SoundMap& map) {
  const auto modes =
      std::ranges::upper_bound(map.frequency, sound_maps::resolved_frequency(map)) - map.frequency.begin();
  return static_cast<double>(modes) * harmonic::solution_time(map.vertices.size());
}

/// The air at a solid's surface; the map gets the name of the model.
/// It says why a map does not have boundary elements alone.
sound_maps::ModalRadiation radiation_of(const MapOptions& options, const scene::Scene& scene,
                                        sound_maps::SoundMap& map) {
  const bool is_quick = boundary_element_time(map) <= longest_time_by_default;
  const MapRadiation model =
      options.radiation.value_or(is_quick ? MapRadiation::boundary_elements : MapRadiation::kirchhoff);
  if (model == MapRadiation::kirchhoff) {
    if (!options.radiation) {
      spdlog::warn(
          "body {}: model kirchhoff, whose levels can be wrong by 10 dB; boundary elements would take about {:.0f} min "
          "on one core: choose a coarser mesh, fewer modes, or --radiation boundary_elements",
          map.body, boundary_element_time(map) / 60.0);
    }
    map.radiation = "kirchhoff";
    return sound_maps::sphere_patches(map, scene.radiation);
  }
  map.radiation = "boundary_elements";
  if (const double resolved = sound_maps::resolved_frequency(map); map.frequency.back() > resolved) {
    map.radiation = fmt::format("boundary_elements up to {:.0f} Hz, kirchhoff above", resolved);
    spdlog::warn("body {}: {}; a finer mesh raises the limit, which is three edges in a wave length", map.body,
                 map.radiation);
  }
  return sound_maps::boundary_elements(map, scene.radiation);
}

/// The mass of the air, if it is asked for; a warning, if it matters. Call on rank 0.
void take_air_mass(const MapOptions& options, sound_maps::SoundMap& map) {
  if (options.in_air) {
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

/// What became of the bodies. Only rank 0 knows the maps and the reasons.
struct Outcome {
  nlohmann::json maps = nlohmann::json::array();      ///< facts of those that are written
  nlohmann::json failures = nlohmann::json::array();  ///< {body, reason}
};

/// Makes a map without its radiation on rank 0. A body without modes is reported, and no reason to stop. Collective.
template <class Modes>
std::optional<sound_maps::SoundMap> find_modes(const std::string& body, const Modes& modes, Outcome& outcome,
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

void write_map(const MapOptions& options, const sound_maps::SoundMap& map, const std::string& name, Outcome& outcome) {
  const auto path = options.output / (name + ".h5");
  sound_maps::write_sound_map(path, map);
  outcome.maps.push_back(map_facts(map, path));
  if (options.style == Style::text) {
    report(map, path);
  }
}

/// Writes the map of one body.
/// @param modes      makes the map without its radiation, on rank 0
/// @param radiation  makes the air at its surface, and names its model in the map
template <class Modes, class Radiation>
void make_map(const MapOptions& options, const scene::Scene& scene, const std::string& body, const Modes& modes,
              const Radiation& radiation, Outcome& outcome, MPI_Comm communicator) {
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
    check_placement(scene, map);
  });
  sound_maps::share_vibrations(map, communicator);
  const sound_maps::ModalRadiation air = radiation(map);
  sound_maps::add_radiation(map, scene, air, communicator);
  parallel::on_root(communicator, [&] { write_map(options, map, name, outcome); });
}

void map_solids(const MapOptions& options, Outcome& outcome, MPI_Comm communicator) {
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, communicator);
  if (parallel::is_root(communicator)) {
    warn(scene);
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
          take_air_mass(options, map);
          return map;
        },
        [&](sound_maps::SoundMap& map) {
          auto radiation = radiation_of(options, scene, map);
          map.radiation += options.in_air ? ", modes with the mass of the air" : "";
          return radiation;
        },
        outcome, communicator);
  }
}

void map_ideal_bodies(const MapOptions& options, Outcome& outcome, MPI_Comm communicator) {
  sound_maps::IdealDeck deck;
  parallel::on_root(communicator, [&] { deck = sound_maps::read_ideal_deck(options.deck, options.overrides); });
  deck = parallel::is_root(communicator) ? deck : sound_maps::read_ideal_deck(options.deck, options.overrides);
  if (parallel::is_root(communicator)) {
    warn(deck.scene);
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
void map_measured_bodies(const MapOptions& options, Outcome& outcome, MPI_Comm communicator) {
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
      write_map(options, map, name, outcome);
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

/// @return the status of the program
int report(const Outcome& outcome, Style style) {
  if (style == Style::json) {
    print_answer(nlohmann::json{{"maps", outcome.maps}, {"without_modes", outcome.failures}});
  }
  if (outcome.failures.empty()) {
    return loop::exit_finished;
  }
  std::string reasons;
  for (const auto& failure : outcome.failures) {
    reasons += "; " + failure["reason"].get<std::string>();
  }
  fmt::print(stderr, "idiophone: {} of {} bodies have no map{}\n", outcome.failures.size(),
             outcome.failures.size() + outcome.maps.size(), reasons);
  return loop::exit_failed;
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
  Outcome outcome;
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
  int status = parallel::is_root(MPI_COMM_WORLD) ? report(outcome, options.style) : loop::exit_finished;
  parallel::broadcast(status, MPI_COMM_WORLD);
  return status;
}

}  // namespace

Command map_command() {
  return make_command<MapOptions>("map", "make sound maps of bodies: all that the sound of a blow needs", Ranks::any,
                                  declare, map);
}

}  // namespace idiophone::app
