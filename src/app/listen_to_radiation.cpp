#include "listen_to_radiation.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "idiophone/air/harmonic/listener_pressures.hpp"
#include "idiophone/air/harmonic/radiation_file.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/scene/listening.hpp"
#include "listener_warnings.hpp"
#include "other_file.hpp"
#include "radiation_answer.hpp"

namespace idiophone::app {

namespace {

scene::Scene read_listeners(const ListenToRadiation& options, const harmonic::StoredRadiation& stored) {
  const auto& [origin, radiation] = stored;
  const scene::RecordedDeck recorded{.recording = options.result,
                                     .name = origin.name,
                                     .text = origin.deck_text,
                                     .overrides = origin.overrides,
                                     .air = {.density = radiation.air_density, .speed = radiation.air_speed},
                                     .has_times = false};
  return scene::read_listening(recorded, options.listeners, options.overrides);
}

/// The floor reflects at the surface, too, so it is part of the solutions.
void require_same_floor(const std::optional<scene::Floor>& wanted, const harmonic::Boundary& surface,
                        const std::filesystem::path& result) {
  const auto& solved = surface.floor;
  const bool same = wanted && solved ? wanted->at == solved->at && wanted->direction == solved->normal &&
                                           wanted->reflection == solved->reflection
                                     : !wanted && !solved;
  if (!same) {
    throw std::runtime_error(
        fmt::format("radiation.floor is not that of {}, which was solved {} floor; leave it out, or "
                    "run radiate on the deck again",
                    result.string(), solved ? "with another" : "without a"));
  }
}

void check(const scene::Scene& scene, const harmonic::Radiation& radiation, const std::filesystem::path& result) {
  const harmonic::Boundary& surface = radiation.surfaces.front();
  require_same_floor(scene.radiation.floor, surface, result);
  warn_of_unheard(scene);
  check_placement(scene,
                  {.names = radiation.parts,
                   .bodies = radiation.bodies,
                   .vertices = surface.vertices,
                   .triangles = surface.triangles,
                   .first_triangle = radiation.first_triangle},
                  propagation::Hearing::exact);
}

}  // namespace

void listen_to_radiation(const ListenToRadiation& options, MPI_Comm communicator) {
  harmonic::StoredRadiation stored;
  std::string name;
  parallel::on_root(communicator, [&] {
    results::require_intact(options.result);
    stored = harmonic::read_radiation(options.result);
    const scene::Scene scene = read_listeners(options, stored);
    check(scene, stored.radiation, options.result);
    harmonic::replace_listeners(stored.radiation, scene.listeners, scene.radiation.air);
    stored.origin.name = scene.name;
    name = radiation_name(scene.name, stored.radiation.bodies, stored.radiation.body);
  });
  parallel::broadcast(name, communicator);
  const loop::OutputLock lock(options.output, name, communicator);
  parallel::on_root(communicator, [&] {
    const auto path = options.output / (name + ".h5");
    require_other_file(path, options.result);
    stored.origin.code_version = program_version;
    write_and_print(path, stored.origin, stored.radiation, options.style);
  });
}

}  // namespace idiophone::app
