#include "listener_warnings.hpp"

#include <spdlog/spdlog.h>

#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::app {

void warn_of_still_listeners(const scene::Scene& scene, const std::string& outcome) {
  for (const auto& listener : scene.listeners) {
    if (listener.path) {
      spdlog::warn("listener {} moves: {} has its place at time 0", listener.name, outcome);
    }
    if (listener.head) {
      spdlog::warn("listener {} has a head: {} has the pressure at its centre, without the head", listener.name,
                   outcome);
    }
  }
}

void check_placement(const scene::Scene& scene, const propagation::Surroundings& around, propagation::Hearing hearing) {
  for (const auto& warning : propagation::placement_warnings(scene, around, hearing)) {
    spdlog::warn(warning);
  }
}

void check_placement(const scene::Scene& scene, const propagation::AudibleSurface& surface, MPI_Comm communicator) {
  const propagation::Surroundings around = propagation::surroundings(surface, communicator);
  parallel::on_root(communicator, [&] { check_placement(scene, around, propagation::hearing_of(scene.radiation)); });
}

}  // namespace idiophone::app
