// `idiophone radiate`: the sound of a vibrating body by boundary elements.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "idiophone/air/harmonic/acoustic_surface.hpp"
#include "idiophone/air/harmonic/body_vibrations.hpp"
#include "idiophone/air/harmonic/radiated_sound.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "listen_to_radiation.hpp"
#include "listener_warnings.hpp"
#include "radiation_answer.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

struct RadiateOptions {
  std::filesystem::path deck;       ///< or a result, if there are other listeners for it
  std::filesystem::path listeners;  ///< deck of other listeners for the result; empty: a deck is solved
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  std::string body;                  ///< empty for the first
  int modes = 10;                    ///< number of modes, the lowest
  std::vector<double> frequencies;   ///< Hz; if there are any, the body moves rigidly along each axis, without modes
  std::filesystem::path velocities;  ///< file; if there is one, the body moves as it says
  harmonic::RadiationOptions accuracy;
  Style style = Style::text;
};

void declare(CLI::App& app, RadiateOptions& options) {
  app.add_option("deck", options.deck,
                 "the scene, a YAML file (docs/use/deck.md); with --listeners, a result NAME_radiation.h5")
      ->required();
  add_overrides(app, options.overrides);
  add_body(app, options.body);
  CLI::Option* modes = app.add_option("--modes", options.modes, "number of modes, the lowest")->capture_default_str();
  CLI::Option* frequencies = app.add_option("--frequencies", options.frequencies,
                                            "Hz,Hz,...: of rigid motions along x, y and z with 1 m/s, instead of modes")
                                 ->delimiter(',')
                                 ->allow_extra_args(false)
                                 ->excludes(modes);
  app.add_option("--velocities", options.velocities, "CSV or .h5 file: velocities of all vertices, instead of modes")
      ->excludes(modes)
      ->excludes(frequencies);
  app.add_option("--waves", options.accuracy.cell, "m: compare with model waves, too, with cells of this size");
  app.add_option("--tolerance", options.accuracy.tolerance,
                 "dB: refine the surface until that changes no level by more; 0: take the mesh as it is")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--most-vertices", options.accuracy.most_vertices, "that a refined surface may have")
      ->check(CLI::Range(1, 10000000))
      ->capture_default_str();
  CLI::Option* listeners = app.add_option("--listeners", options.listeners,
                                          "YAML file: listeners that hear the result, without solving it again");
  for (const char* other :
       {"--body", "--modes", "--frequencies", "--velocities", "--waves", "--tolerance", "--most-vertices"}) {
    listeners->excludes(other);
  }
  add_output_folder(app, options.output, "folder of the results");
  add_json(app, options.style);
}

constexpr double good_resolution = 6.0;  ///< elements in a wavelength of sound

void check_radiate(const RadiateOptions& options) {
  if (options.modes < 1) {
    throw std::runtime_error(fmt::format("--modes must be at least 1, not {}", options.modes));
  }
  for (const double frequency : options.frequencies) {
    if (!(frequency > 0 && std::isfinite(frequency))) {
      throw std::runtime_error(fmt::format("--frequencies must be above 0 Hz, not {}", frequency));
    }
  }
}

/// Refuses what the comparison with model waves cannot do.
void check_grid(const scene::Scene& scene, const std::optional<double>& cell) {
  if (cell && !(*cell >= 1e-4 && *cell <= 1.0)) {
    throw std::runtime_error(fmt::format("--waves must be from 0.0001 to 1 m, not {}", *cell));
  }
  if (cell && scene.radiation.floor) {
    throw std::runtime_error("--waves compares in the open air only; take radiation.floor out of the deck");
  }
}

void warn_of_omissions(const scene::Scene& scene) {
  for (const auto& body : scene.recorded_bodies) {
    spdlog::warn("body {} is a recording: it is left out", body.name);
  }
  for (const auto& obstacle : scene.obstacles) {
    if (obstacle.shape == scene::Obstacle::Shape::half_space) {
      spdlog::warn("obstacle {} is a half-space: it is left out; radiation: {{floor: ...}} reflects sound",
                   obstacle.name);
    }
  }
  warn_of_unheard(scene);
}

/// The part of the surface that has a body: its place among the assemblies.
std::size_t part_of(const std::vector<std::vector<std::size_t>>& assemblies, std::size_t body) {
  const auto found = std::ranges::find_if(
      assemblies, [&](const std::vector<std::size_t>& bodies) { return std::ranges::binary_search(bodies, body); });
  return found - assemblies.begin();
}

std::vector<harmonic::Vibration> vibrations_of(const scene::Scene& scene, std::size_t part,
                                               const harmonic::AcousticSurface& surface,
                                               const RadiateOptions& options) {
  if (!options.velocities.empty()) {
    return harmonic::given_vibrations(part, options.velocities, surface);
  }
  return options.frequencies.empty() ? harmonic::modal_vibrations(scene, part, options.modes, surface)
                                     : harmonic::rigid_vibrations(part, options.frequencies, surface);
}

/// Refuses what is too coarse.
void check_resolution(const std::vector<harmonic::Vibration>& vibrations, double edge, double speed) {
  for (const harmonic::Vibration& vibration : vibrations) {
    const double resolution = speed / vibration.frequency / edge;
    const std::string problem =
        fmt::format("{} at {:.0f} Hz: the longest edge of the surface is 1/{:.1f} of a wavelength", vibration.name,
                    vibration.frequency, resolution);
    if (resolution < harmonic::least_resolution) {
      throw std::runtime_error(
          fmt::format("{}, which must be at least 1/{}; choose a finer mesh", problem, harmonic::least_resolution));
    }
    if (resolution < good_resolution) {
      spdlog::warn("{}; levels are good to 0.1 dB from 1/{} on", problem, good_resolution);
    }
  }
}

/// Rank 0's surface and vibrations, on all ranks.
void share(harmonic::AcousticSurface& surface, std::vector<harmonic::Vibration>& vibrations, MPI_Comm communicator) {
  parallel::broadcast(surface.boundary.vertices, communicator);
  parallel::broadcast(surface.boundary.triangles, communicator);
  parallel::broadcast(surface.bodies, communicator);
  parallel::broadcast(surface.parts, communicator);
  parallel::broadcast(surface.first_triangle, communicator);
  auto count = vibrations.size();
  parallel::broadcast(count, communicator);
  vibrations.resize(count);
  for (harmonic::Vibration& vibration : vibrations) {
    parallel::broadcast(vibration.name, communicator);
    parallel::broadcast(vibration.frequency, communicator);
    parallel::broadcast(vibration.energy, communicator);
    parallel::broadcast(vibration.velocity, communicator);
    parallel::broadcast(vibration.normal_velocity, communicator);
  }
}

/// Says which levels may be wrong.
void warn_of_errors(const harmonic::Radiation& result, const harmonic::RadiationOptions& accuracy) {
  if (accuracy.tolerance == 0.0) {
    return;
  }
  const std::string remedy =
      fmt::format("a finer surface would have more than {} vertices (--most-vertices)", accuracy.most_vertices);
  for (const harmonic::RadiatedSound& sound : result.sounds) {
    if (std::isnan(sound.level_error)) {
      spdlog::warn("{}: the error of its level is unknown; {}", sound.name, remedy);
    } else if (sound.level_error > accuracy.tolerance) {
      spdlog::warn("{}: its level can be wrong by {:.1f} dB; {}", sound.name, sound.level_error, remedy);
    }
  }
}

int radiate(const RadiateOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  if (!options.listeners.empty()) {
    listen_to_radiation({.result = options.deck,
                         .listeners = options.listeners,
                         .overrides = options.overrides,
                         .output = options.output,
                         .style = options.style},
                        communicator);
    return loop::exit_finished;
  }
  check_radiate(options);
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, communicator);
  check_grid(scene, options.accuracy.cell);
  const auto assemblies = scene::assemblies(scene);
  const std::size_t part = part_of(assemblies, scene::find_body(scene.bodies, options.body));
  const std::string name = radiation_name(scene.name, assemblies.size(), scene.bodies[assemblies[part].front()].name);
  const loop::OutputLock lock(options.output, name, communicator);
  harmonic::AcousticSurface surface;
  std::vector<harmonic::Vibration> vibrations;
  parallel::on_root(communicator, [&] {
    warn_of_omissions(scene);
    surface = harmonic::acoustic_surface(scene, scene.radiation.floor);
    check_placement(scene,
                    {.names = surface.parts,
                     .bodies = surface.bodies,
                     .vertices = surface.boundary.vertices,
                     .triangles = surface.boundary.triangles,
                     .first_triangle = surface.first_triangle},
                    propagation::Hearing::exact);
    if (options.frequencies.empty() && options.velocities.empty()) {
      spdlog::info("finding the {} lowest modes", options.modes);
    }
    vibrations = vibrations_of(scene, part, surface, options);
    const harmonic::BoundaryElements elements(surface.boundary, {});
    check_resolution(vibrations, elements.longest_edge(), scene.radiation.air.speed);
    spdlog::info("solving the sound of {} motions up to {:.0f} Hz on a surface of {} vertices", vibrations.size(),
                 std::ranges::max_element(vibrations, {}, &harmonic::Vibration::frequency)->frequency,
                 surface.boundary.vertices.size());
  });
  share(surface, vibrations, communicator);
  const harmonic::Radiation result = [&] {
    loop::PieceProgress progress = piece_progress("frequencies", options.style, communicator);
    return harmonic::radiated_sounds(scene, part, surface, vibrations, options.accuracy, communicator,
                                     parts_watched_by(progress));
  }();
  parallel::on_root(communicator, [&] {
    warn_of_errors(result, options.accuracy);
    write_and_print(options.output / (name + ".h5"), {scene.name, program_version, scene.deck_text, scene.overrides},
                    result, options.style);
    if (result.sounds.size() < vibrations.size()) {
      spdlog::error("stopped by a signal: {} of {} motions are left out", vibrations.size() - result.sounds.size(),
                    vibrations.size());
    }
  });
  return result.sounds.size() < vibrations.size() ? loop::exit_resumable : loop::exit_finished;
}

}  // namespace

Command radiate_command() {
  return make_command<RadiateOptions>("radiate", "compute the sound of a vibrating body by boundary elements",
                                      Ranks::any, declare, radiate);
}

}  // namespace idiophone::app
