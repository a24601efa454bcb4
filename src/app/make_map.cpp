#include "make_map.hpp"

#include <spdlog/spdlog.h>

#include <optional>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "map_warnings.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

constexpr std::size_t rings_of_directions = 16;

/// Makes a map on rank 0. A body without modes is reported. Collective.
std::optional<sound_maps::SoundMap> find_modes(const std::string& body, const FindModes& modes, MapOutcome& outcome,
                                               MPI_Comm communicator) {
  sound_maps::SoundMap map;
  bool has_modes = true;
  parallel::on_root(communicator, [&] {
    try {
      map = modes();
    } catch (const eigenmodes::NoModes& error) {
      const std::string reason =
          error.what() + std::string(error.lowest ? " (--up-to more than that, or --modes)" : "");
      spdlog::error("{}. There is no map of it; those of others are made", reason);
      outcome.failures.push_back({{"body", body}, {"reason", reason}});
      has_modes = false;
    }
  });
  parallel::broadcast(has_modes, communicator);
  return has_modes ? std::optional(std::move(map)) : std::nullopt;
}

/// Adds the sound of the modes and shows the progress; a signal ends it with the modes that are done.
void add_sound(const MapOptions& options, const scene::Scene& scene, const sound_maps::ModalRadiation& air,
               sound_maps::SoundMap& map, const std::string& body, MapOutcome& outcome, MPI_Comm communicator) {
  WatchedWork radiation("modes of " + body, options.style, communicator);
  sound_maps::add_radiation(map, scene, air, communicator, radiation.watch());
  radiation.note_left_out(outcome.stopped);
}

}  // namespace

std::string map_name(const scene::Scene& scene, const std::string& body) {
  return scene.name + "_" + body + ".map";
}

std::filesystem::path path_of_map(const MapOptions& options, const std::string& name) {
  return options.output / (name + ".h5");
}

void make_map(const MapOptions& options, const scene::Scene& scene, const std::string& body, const FindModes& modes,
              const FindRadiation& radiation, MapOutcome& outcome, MPI_Comm communicator) {
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
    check_map_placement(scene, map);
  });
  bool is_complete = !map.sphere.pressure.empty();
  parallel::broadcast(is_complete, communicator);
  if (!is_complete) {
    map.sphere = sound_maps::sphere_of_directions(rings_of_directions);
    sound_maps::share_vibrations(map, communicator);
    add_sound(options, scene, radiation(map), map, body, outcome, communicator);
  }
  parallel::on_root(communicator, [&] { write_map(path_of_map(options, name), map, options.style, outcome); });
}

}  // namespace idiophone::app
