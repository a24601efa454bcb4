#include "steps.hpp"

#include <algorithm>

#include "idiophone/air/surface/sampling.hpp"
#include "idiophone/air/waves/plan.hpp"
#include "idiophone/air/waves/surface_sources.hpp"

namespace idiophone::bodies {

namespace {

/// With fewer steps of the motion in one of the air, the air could give energy to the bodies (docs/method/waves.md).
constexpr int least_steps_in_one_of_air = 4;

}  // namespace

double lightest_surface(const Preparation& ready) {
  return std::ranges::min(ready.initial_state.surface_densities);
}

double stable_step_in_air(const Preparation& ready) {
  const scene::AirProperties& air = ready.scene.radiation.air;
  const double resistance = air.impedance() * waves::largest_resistance(waves::courant_of(
                                                  air.speed, ready.scene.radiation.grid.cell, ready.scene.audio.rate));
  return 1.0 / (1.0 / ready.initial_state.stable_step() + resistance / (2.0 * lightest_surface(ready)));
}

std::optional<double> own_step(const scene::Scene& scene) {
  if (!scene.time.steps_per_sample) {
    return std::nullopt;
  }
  return 1.0 / (*scene.time.steps_per_sample * scene.audio.rate);
}

int find_steps_per_sample(const Preparation& ready) {
  const scene::Scene& scene = ready.scene;
  if (!scene.radiation.grid.back) {
    return motion::choose_steps_per_sample(scene.time, scene.audio, ready.initial_state.stable_step(),
                                           ready.initial_state.highest_loss());
  }
  const int of_air = waves::steps_in_sample(scene.radiation.air.speed, scene.radiation.grid.cell, scene.audio.rate);
  const double longest = 1.0 / (static_cast<double>(least_steps_in_one_of_air) * of_air * scene.audio.rate);
  return motion::choose_steps_per_sample(scene.time, scene.audio, std::min(stable_step_in_air(ready), longest),
                                         ready.initial_state.highest_loss(), of_air);
}

}  // namespace idiophone::bodies
