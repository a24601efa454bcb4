#include "steps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "idiophone/air/surface/sampling.hpp"
#include "idiophone/air/waves/plan.hpp"
#include "idiophone/air/waves/surface_coupling.hpp"

namespace idiophone::bodies {

namespace {

/// With fewer steps of the motion in one of the air, the air could give energy to the bodies (docs/method/waves.md).
constexpr int least_steps_in_one_of_air = 4;

}  // namespace

bool is_held_everywhere(const Preparation& ready, std::size_t body) {
  return !ready.modal_bases.contains(body) && !ready.initial_state.steps[body].is_limited();
}

double lightest_surface(const Preparation& ready) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    if (!is_held_everywhere(ready, b)) {
      least = std::min(least, ready.initial_state.surface_densities[b]);
    }
  }
  return least;
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

std::string contact_as_cause(const Preparation& ready) {
  const std::size_t body = ready.initial_state.limiting_body();
  const motion::StepCause cause = ready.initial_state.steps[body].cause;
  if (cause == motion::StepCause::elements) {
    return {};
  }
  const bool bristles = cause == motion::StepCause::bristles;
  std::vector<std::string> names;
  for (const scene::Contact& contact : ready.scene.contacts) {
    if ((contact.body == body || contact.other == body) && (!bristles || contact.friction.memory)) {
      names.push_back("contacts." + contact.name);
    }
  }
  const std::string joined = fmt::format("{}", fmt::join(names, ", "));
  return bristles
             ? fmt::format("The bristles of {} make it short: lower friction.stiffness, damping or viscosity", joined)
             : fmt::format("The stiffness or the damping of {} makes it short: lower it", joined);
}

int find_steps_per_sample(const Preparation& ready) {
  const scene::Scene& scene = ready.scene;
  if (!scene.radiation.grid.back) {
    return motion::choose_steps_per_sample(scene.time, scene.audio, ready.initial_state.stable_step(),
                                           ready.initial_state.highest_loss(), 1, contact_as_cause(ready));
  }
  const int of_air = waves::steps_in_sample(scene.radiation.air.speed, scene.radiation.grid.cell, scene.audio.rate);
  const double longest = 1.0 / (static_cast<double>(least_steps_in_one_of_air) * of_air * scene.audio.rate);
  return motion::choose_steps_per_sample(scene.time, scene.audio, std::min(stable_step_in_air(ready), longest),
                                         ready.initial_state.highest_loss(), of_air, contact_as_cause(ready));
}

}  // namespace idiophone::bodies
