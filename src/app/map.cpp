#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "idiophone/modal/modal_radiation.hpp"
#include "idiophone/modal/solid_map.hpp"
#include "idiophone/parallel/communicator.hpp"
#include "idiophone/parallel/errors.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/store/sound_map.hpp"
#include "output_lock.hpp"
#include "read_deck.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

constexpr std::size_t rings_of_directions = 16;

/// What of the deck does not reach its maps.
void warn(const scene::Scene& scene) {
  for (const auto& body : scene.recorded_bodies) {
    spdlog::warn("body {} is a recording: it has no modes and gets no map", body.name);
  }
  if (scene.radiation.model != scene::RadiationModel::kirchhoff) {
    spdlog::warn("maps are made with radiation model kirchhoff, in pascals; the deck has another model");
  }
  if (scene.bodies.size() + scene.obstacles.size() > 1) {
    spdlog::warn("each body is heard alone: other bodies and obstacles cast no shadow in its map");
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

void report(const store::SoundMap& map, const std::filesystem::path& path) {
  spdlog::info("{}: body {}, {} modes from {:.6g} to {:.6g} Hz, {} vertices, {} triangles, {} listeners, {} directions",
               path.string(), map.body, map.modes(), map.frequency.front(), map.frequency.back(), map.vertices.size(),
               map.triangles.size(), map.listeners.size(), map.sphere.direction.size());
}

void make_map(const MapOptions& options, const scene::Scene& scene, std::size_t body, MPI_Comm communicator) {
  const std::string name = scene.name + "_" + scene.bodies[body].name + ".map";
  const OutputLock lock(options.output, name, communicator);
  store::SoundMap map;
  parallel::on_root(communicator, [&] {
    map = modal::solid_map(
        scene, body,
        {.count = options.count.value_or(1), .up_to = options.count ? std::nullopt : std::optional(options.up_to)});
    map.code_version = IDIOPHONE_VERSION;
    map.resolved_deck = scene::resolved_deck(options.deck, options.overrides);
    map.sphere = modal::sphere_of_directions(rings_of_directions);
  });
  modal::share_vibrations(map, communicator);
  modal::add_radiation(map, scene, modal::sphere_patches(map, scene.radiation), communicator);
  parallel::on_root(communicator, [&] {
    const auto path = options.output / (name + ".h5");
    store::write_sound_map(path, map);
    report(map, path);
  });
}

}  // namespace

int map(const MapOptions& options) {
  const scene::Scene scene = read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  if (parallel::is_root(MPI_COMM_WORLD)) {
    warn(scene);
  }
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    make_map(options, scene, body, MPI_COMM_WORLD);
  }
  return exit_finished;
}

}  // namespace idiophone::app
