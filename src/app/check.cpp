// `idiophone check`: everything up to the first step, sizes and costs.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/air/propagation/wave_plan.hpp"
#include "idiophone/air/waves/wave_field.hpp"
#include "idiophone/foundation/parallel/clock.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/run/bodies/prepared_surface.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/resources.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/record/surface_recorder.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/solids/accuracy/recommendation.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "idiophone/solids/solid/mass_scaling.hpp"
#include "idiophone/study/advice/radiation_warnings.hpp"
#include "idiophone/study/advice/rank_prediction.hpp"
#include "idiophone/study/advice/recommendations.hpp"

namespace idiophone::app {

namespace {

struct CheckOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";        ///< whose free space is compared
  std::optional<double> accuracy;                  ///< cents, of the recommended mesh
  std::optional<double> up_to;                     ///< Hz, likewise; no mesh is recommended if both are empty
  std::optional<int> ranks;                        ///< predict a run on so many
  std::optional<double> latency;                   ///< of a message between them, s; see usual_latency
  double bandwidth = advice::Network{}.bandwidth;  ///< of a rank, bytes/s
  Style style = Style::text;
};

void declare(CLI::App& app, CheckOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_output_folder(app, options.output, "folder of the results, whose free space is compared");
  app.add_option("--accuracy", options.accuracy,
                 "cents: recommend the cheapest mesh with this accuracy of pitch (default with --up-to: 5)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_option("--up-to", options.up_to, "Hz: up to this frequency (default with --accuracy: 5000)")
      ->check(CLI::Range(1.0, 1e5));
  app.add_option("-n,--ranks", options.ranks,
                 "predict sizes, memory and speed-up of a run on so many ranks; start without mpirun")
      ->check(CLI::Range(1, 1 << 20));
  app.add_option("--latency", options.latency,
                 "s: of a message between two ranks, for --ranks (default: 2e-6, or 4e-7 if this machine has a "
                 "processor for each rank)")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--bandwidth", options.bandwidth, "bytes/s: of a rank, for --ranks")
      ->check(CLI::Range(1.0, 1e15))
      ->capture_default_str();
  add_json(app, options.style);
  app.add_flag_callback(
      "--resolved", [&options] { options.style = Style::deck; },
      "print the deck with overrides and defaults, itself a deck, and do nothing else");
}

constexpr double mega = 1e6;

/// What is measured on a motion of all bodies.
struct Measurement {
  advice::StepSeconds step;  ///< of the slowest rank
  advice::MemoryEstimate memory;
};

/// Seconds of a call, the mean of several.
template <class Call>
double seconds_of(int calls, const Call& call) {
  const double start = parallel::wall_time();
  for (int i = 0; i < calls; ++i) {
    call();
  }
  return (parallel::wall_time() - start) / calls;
}

/// From a fraction of a second of stepping from rest. Collective.
/// @param program  memory before the meshes were read, bytes
Measurement measure(const bodies::Preparation& ready, double program) {
  motion::Motion motion(ready.scene, ready.part, ready.attachments, ready.contact_surfaces, ready.step(),
                        ready.steps_per_sample, MPI_COMM_WORLD, ready.models());
  motion.start(ready.initial_state.centres, ready.initial_state.displacement);
  constexpr int warm_up = 2;
  constexpr int steps = 20;
  static_cast<void>(seconds_of(warm_up, [&] { motion.advance(); }));
  const double whole = seconds_of(steps, [&] { motion.advance(); });
  std::vector<solid::NodeForce> force(motion.state().size());
  const double of_force =
      seconds_of(steps, [&] { motion.dynamics().compute_force(motion.time(), motion.state(), force); });
  return {.step = {.force = parallel::largest(std::min(of_force, whole), MPI_COMM_WORLD),
                   .whole = parallel::largest(whole, MPI_COMM_WORLD)},
          .memory = advice::MemoryEstimate(ready, motion.dynamics(), program)};
}

std::string duration_text(double seconds) {
  if (seconds < 120) {
    return fmt::format("{:.0f} s", seconds);
  }
  return seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

void report_mesh(const bodies::Preparation& ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& mesh = ready.statistics[b];
    spdlog::info(
        "body {}: edges {:.4g} to {:.4g} m, volume {:.6g} m3; worst element {} at ({:.4g}, {:.4g}, {:.4g}), quality "
        "{:.3f}",
        ready.scene.bodies[b].name, mesh.smallest_edge, mesh.largest_edge, mesh.volume, mesh.worst_element,
        mesh.worst_centre[0], mesh.worst_centre[1], mesh.worst_centre[2], mesh.worst_quality);
  }
}

/// What the mesh does to the pitch of a body, where that is heard.
std::optional<std::string> pitch_warning(const bodies::Preparation& ready, std::size_t b) {
  const auto& body = ready.scene.bodies[b];
  if (!ready.initial_state.steps[b].is_limited()) {
    return {};
  }
  return accuracy::mesh_warning(ready.statistics[b], body, ready.scene.materials[body.material],
                                std::min(ready.scene.audio.max_frequency, solid::highest_audible));
}

void report_pitch(const bodies::Preparation& ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    if (const auto limits = loop::pitch_limits(ready, b)) {
      spdlog::info(
          "body {}: pitch within about 5 cents up to {:.0f} Hz, 50 cents up to {:.0f} Hz, by the rules for even cells; "
          "`idiophone modes` estimates the error of each mode",
          ready.scene.bodies[b].name, limits->first, limits->second);
    } else if (!accuracy::has_rules(accuracy::extents(ready.statistics[b]))) {
      spdlog::info(
          "body {}: there is no rule for the pitch of curved or joined thin walls; `idiophone modes` estimates the "
          "error "
          "of each mode",
          ready.scene.bodies[b].name);
    }
    if (const auto warning = pitch_warning(ready, b)) {
      spdlog::warn(*warning);
    }
  }
}

void report_radiation(const bodies::Preparation& ready) {
  for (const std::string& warning : advice::radiation_warnings(ready)) {
    spdlog::warn(warning);
  }
}

/// What waves on a grid need.
struct WaveCosts {
  waves::Plan plan;
  double step_seconds = 0.0;  ///< wall clock of one step, s
};

/// From a few steps of open air. Collective.
/// @return none with other radiation models
std::optional<WaveCosts> measure_waves(const bodies::Preparation& ready) {
  if (ready.scene.radiation.model != scene::RadiationModel::waves) {
    return {};
  }
  WaveCosts costs;
  costs.plan = propagation::wave_plan(ready.scene, bodies::audible_surface(ready, MPI_COMM_WORLD), MPI_COMM_WORLD);
  waves::WaveField field(
      waves::Slab::of_rank(costs.plan.grid, parallel::rank_of(MPI_COMM_WORLD), parallel::size_of(MPI_COMM_WORLD)),
      costs.plan.courant, MPI_COMM_WORLD);
  field.step({});
  costs.step_seconds = parallel::largest(seconds_of(3, [&] { field.step({}); }), MPI_COMM_WORLD);
  return costs;
}

void report(const WaveCosts& costs, const scene::Scene& scene) {
  const waves::Plan& plan = costs.plan;
  const double samples = scene.time.duration * scene.audio.rate;
  spdlog::info("waves: {} x {} x {} cells of {:.4g} m, {} steps in an audio sample, about {:.0f} MB of memory",
               plan.grid.cells[0], plan.grid.cells[1], plan.grid.cells[2], plan.grid.cell, plan.steps,
               plan.bytes() / mega);
  spdlog::info("waves: levels hold up to {:.0f} Hz (10 cells a wavelength); {} for all steps ({:.3g} ms each)",
               plan.highest_frequency(scene.radiation.air.speed),
               duration_text(samples * plan.steps * costs.step_seconds), 1e3 * costs.step_seconds);
}

/// What a run will need.
struct Costs {
  double samples = 0.0;  ///< of audio
  double steps = 0.0;
  double memory = 0.0;        ///< of all ranks, bytes
  double sound = 0.0;         ///< in the result, bytes
  double frames = 0.0;        ///< in the result, bytes
  double recording = 0.0;     ///< of surface motion, bytes
  double step_seconds = 0.0;  ///< wall clock of one step, s
  double seconds = 0.0;       ///< wall clock of the run, s
  int ranks = 1;
};

/// @param memory  of all ranks, bytes
Costs estimate(const bodies::Preparation& ready, double step_seconds, double memory,
               const std::optional<WaveCosts>& waves) {
  const auto& scene = ready.scene;
  double channels = 0.0;
  for (const auto& listener : scene.listeners) {
    channels += static_cast<double>(listener.receivers.size());
  }
  Costs costs;
  costs.samples = scene.time.duration * scene.audio.rate;
  costs.steps = costs.samples * ready.steps_per_sample;
  costs.memory = memory + (waves ? waves->plan.bytes() : 0.0);
  costs.sound = costs.samples * channels * sizeof(double);
  costs.frames = scene.time.duration * scene.output.frames_per_second * ready.part.global_nodes * 3 * sizeof(float);
  costs.recording = scene.output.surface_motion ? record::recorded_bytes_per_sample(ready) * costs.samples : 0.0;
  costs.step_seconds = step_seconds;
  costs.seconds = costs.steps * step_seconds * 1.05;
  if (waves) {
    costs.seconds += costs.samples * waves->plan.steps * waves->step_seconds;
  }
  costs.ranks = parallel::size_of(MPI_COMM_WORLD);
  return costs;
}

void report(const Costs& costs, double duration) {
  spdlog::info("{:.0f} audio samples, {:.4g} steps", costs.samples, costs.steps);
  spdlog::info("about {:.0f} MB of memory in all; result of {:.1f} MB, {:.1f} MB of it frames", costs.memory / mega,
               (costs.sound + costs.frames) / mega, costs.frames / mega);
  if (costs.recording > 0) {
    spdlog::info("recorded surface motion: {:.1f} MB for each second of sound, {:.1f} MB in all",
                 costs.recording / duration / mega, costs.recording / mega);
  }
  spdlog::info("about {} on {} rank{} (a step takes {:.3g} ms; sound and files add some 5 %)",
               duration_text(costs.seconds), costs.ranks, costs.ranks == 1 ? "" : "s", 1e3 * costs.step_seconds);
}

/// What mesh is wanted, if --accuracy or --up-to is given.
std::optional<accuracy::Accuracy> wanted_accuracy(const CheckOptions& options) {
  if (!options.accuracy && !options.up_to) {
    return {};
  }
  return accuracy::Accuracy{.cents = options.accuracy.value_or(5), .frequency = options.up_to.value_or(5000)};
}

void print_json(const bodies::Preparation& ready, const Costs& costs, const std::optional<accuracy::Accuracy>& wanted,
                const std::optional<advice::RankPrediction>& prediction) {
  nlohmann::json answer = loop::size_facts(ready);
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& body = ready.scene.bodies[b];
    auto& facts = answer["bodies"][body.name];
    facts["warning"] = pitch_warning(ready, b).value_or("");
    facts["radiation_warning"] =
        advice::radiation_warning(body.name, ready.statistics[b], ready.scene.radiation).value_or("");
    if (const auto& limit = ready.initial_state.steps[b]; limit.is_limited()) {
      facts["processor_seconds"] = accuracy::seconds_of(ready.statistics[b], body.element, limit.step);
    }
    if (wanted) {
      facts["recommended"] = advice::recommendation_facts(ready, b, *wanted);
    }
  }
  answer["costs"] = {
      {"samples", costs.samples},           {"steps", costs.steps},         {"memory_bytes", costs.memory},
      {"sound_bytes", costs.sound},         {"frames_bytes", costs.frames}, {"recording_bytes", costs.recording},
      {"step_seconds", costs.step_seconds}, {"seconds", costs.seconds},     {"ranks", costs.ranks}};
  if (prediction) {
    answer["prediction"] = advice::facts_of(*prediction);
  }
  print_answer(answer);
}

int check(const CheckOptions& options) {
  if (options.style == Style::deck) {
    parallel::on_root(MPI_COMM_WORLD, [&] { fmt::print("{}", scene::resolved_deck(options.deck, options.overrides)); });
    return loop::exit_finished;
  }
  if (options.ranks && parallel::size_of(MPI_COMM_WORLD) > 1) {
    throw std::runtime_error("check --ranks predicts a run on one process: start it without mpirun");
  }
  const double program = loop::peak_memory();
  scene::Scene scene = bodies::read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  const std::vector<mesh::Mesh> meshes = bodies::read_meshes(scene.bodies, MPI_COMM_WORLD);
  const bodies::Preparation ready = bodies::prepare(std::move(scene), meshes, MPI_COMM_WORLD);
  const Measurement measured = measure(ready, program);
  const std::optional<WaveCosts> waves = measure_waves(ready);
  const double needed = parallel::sum(measured.memory.of(ready.part), MPI_COMM_WORLD);
  const double memory = loop::memory_of_machines(MPI_COMM_WORLD);
  if (!parallel::is_root(MPI_COMM_WORLD)) {
    return loop::exit_finished;
  }
  const Costs costs = estimate(ready, measured.step.whole, needed, waves);
  std::optional<advice::RankPrediction> prediction;
  if (options.ranks) {
    const int ranks = *options.ranks;
    const advice::Network network{.latency = options.latency.value_or(advice::usual_latency(ranks)),
                                  .bandwidth = options.bandwidth};
    prediction = advice::predict_ranks(meshes, ranks, measured.step, network, measured.memory);
  }
  if (options.style == Style::json) {
    print_json(ready, costs, wanted_accuracy(options), prediction);
  } else {
    report_mesh(ready);
    report_pitch(ready);
    report_radiation(ready);
    if (waves) {
      report(*waves, ready.scene);
    }
    if (const auto wanted = wanted_accuracy(options)) {
      for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
        advice::print_recommendation(ready, b, *wanted);
      }
    }
    report(costs, ready.scene.time.duration);
    if (prediction) {
      report(*prediction);
    }
  }
  loop::compare_memory(costs.memory, memory);
  loop::compare_disk(costs.sound + costs.frames + costs.recording, options.output);
  return loop::exit_finished;
}

}  // namespace

Command check_command() {
  return make_command<CheckOptions>("check", "validate and mesh a deck; print sizes, step, memory and time", Ranks::any,
                                    declare, check);
}

}  // namespace idiophone::app
