#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "commands.hpp"
#include "idiophone/element/reference.hpp"
#include "idiophone/mesh/pitch_error.hpp"
#include "idiophone/motion/motion.hpp"
#include "idiophone/parallel/communicator.hpp"
#include "idiophone/record/surface_recorder.hpp"
#include "idiophone/solid/relaxation.hpp"
#include "idiophone/source/preparation.hpp"
#include "read_deck.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

constexpr double mega = 1e6;

/// Seconds of one step on this rank, from a fraction of a second of stepping from rest.
double measured_step(const source::Preparation& ready) {
  motion::Motion motion(ready.scene, ready.part, ready.attachments, ready.partners, ready.step(),
                        ready.steps_per_sample, MPI_COMM_WORLD);
  motion.start(ready.initial_state.centres, ready.initial_state.displacement);
  constexpr int warm_up = 2;
  constexpr int steps = 20;
  for (int i = 0; i < warm_up; ++i) {
    motion.advance();
  }
  const double start = MPI_Wtime();
  for (int i = 0; i < steps; ++i) {
    motion.advance();
  }
  double seconds = (MPI_Wtime() - start) / steps;
  MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return seconds;
}

std::string duration_text(double seconds) {
  if (seconds < 120) {
    return fmt::format("{:.0f} s", seconds);
  }
  return seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

void report_mesh(const source::Preparation& ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& mesh = ready.statistics[b];
    spdlog::info(
        "body {}: edges {:.4g} to {:.4g} m, volume {:.6g} m3; worst element {} at ({:.4g}, {:.4g}, {:.4g}), quality "
        "{:.3f}",
        ready.scene.bodies[b].name, mesh.smallest_edge, mesh.largest_edge, mesh.volume, mesh.worst_element,
        mesh.worst_centre[0], mesh.worst_centre[1], mesh.worst_centre[2], mesh.worst_quality);
  }
}

/// What the meshes do to the pitch of what sounds (docs/mesh_guide.md).
void report_pitch(const source::Preparation& ready) {
  const double highest = std::min(ready.scene.audio.max_frequency, solid::highest_audible);
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& body = ready.scene.bodies[b];
    const auto& mesh = ready.statistics[b];
    const auto& material = ready.scene.materials[body.material];
    if (!ready.initial_state.steps[b].is_limited()) {
      continue;
    }
    switch (body.element.kind) {
      case element::Kind::tet4:
      case element::Kind::hex:
        break;  // no pitch to promise
      case element::Kind::tet10:
        spdlog::info("body {}: pitch within about 5 cents up to {:.0f} Hz, 50 cents up to {:.0f} Hz", body.name,
                     mesh::highest_frequency(mesh, material, 5), mesh::highest_frequency(mesh, material, 50));
        break;
    }
    if (const auto warning = mesh::mesh_warning(mesh, body, material, highest)) {
      spdlog::warn(*warning);
    }
  }
}

/// Geometry and node numbers of an element.
double bytes_of_element(element::Type type) {
  switch (type.kind) {
    case element::Kind::tet4:
      return 96 + 32;
    case element::Kind::tet10:
      return 360 + 60;
    case element::Kind::hex:
      return (80 + 4) * element::node_count(type);
  }
  element::unknown_kind();
}

/// What an element remembers of its strain for one mechanism of a loss factor: six numbers at each quadrature point.
double bytes_of_mechanism(element::Type type) {
  return static_cast<double>(6 * sizeof(double) * element::reference(type).quadrature.size());
}

void report_costs(const source::Preparation& ready, double step_seconds) {
  const auto& scene = ready.scene;
  double channels = 0.0;
  for (const auto& listener : scene.listeners) {
    channels += static_cast<double>(listener.receivers.size());
  }
  // Bytes: state, force and mass of a node; geometry and node numbers of an element; filters of a triangle.
  double memory = 120.0 * ready.part.global_nodes + 600.0 * ready.part.global_triangles;
  for (const auto& body : ready.scene.bodies) {
    const auto b = static_cast<std::size_t>(&body - scene.bodies.data());
    const double elements = ready.offsets.elements[b + 1] - ready.offsets.elements[b];
    memory += elements * bytes_of_element(body.element);
    if (const auto& loss = scene.materials[body.material].damping.loss) {
      const auto mechanisms = static_cast<double>(solid::fit_relaxation(*loss).mechanisms.size());
      memory += elements * mechanisms * bytes_of_mechanism(body.element);
    }
  }
  const double samples = scene.time.duration * scene.audio.rate;
  const double sound = samples * channels * sizeof(double);
  const double frames =
      scene.time.duration * scene.output.frames_per_second * ready.part.global_nodes * 3 * sizeof(float);
  spdlog::info("{:.0f} audio samples, {:.4g} steps", samples, samples * ready.steps_per_sample);
  spdlog::info("about {:.0f} MB of memory in all; result of {:.1f} MB, {:.1f} MB of it frames", memory / mega,
               (sound + frames) / mega, frames / mega);
  if (scene.output.surface_motion) {
    const double recorded = record::recorded_bytes_per_sample(ready);
    spdlog::info("recorded surface motion: {:.1f} MB for each second of sound, {:.1f} MB in all",
                 recorded * scene.audio.rate / mega, recorded * samples / mega);
  }
  const int ranks = parallel::size_of(MPI_COMM_WORLD);
  spdlog::info("about {} on {} rank{} (a step takes {:.3g} ms; sound and files add some 5 %)",
               duration_text(samples * ready.steps_per_sample * step_seconds * 1.05), ranks, ranks == 1 ? "" : "s",
               1e3 * step_seconds);
}

}  // namespace

int check(const RunOptions& options) {
  const source::Preparation ready =
      source::prepare(read_deck(options.deck, options.overrides, MPI_COMM_WORLD), MPI_COMM_WORLD);
  const double step_seconds = measured_step(ready);
  if (parallel::is_root(MPI_COMM_WORLD)) {
    report_mesh(ready);
    report_pitch(ready);
    report_costs(ready, step_seconds);
  }
  return exit_finished;
}

}  // namespace idiophone::app
