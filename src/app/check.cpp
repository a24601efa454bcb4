// `idiophone check`: everything up to the first step, sizes and costs.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "command.hpp"
#include "face_table.hpp"
#include "idiophone/air/propagation/wave_plan.hpp"
#include "idiophone/air/waves/plan.hpp"
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
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/solids/accuracy/recommendation.hpp"
#include "idiophone/study/advice/processor_clock.hpp"
#include "idiophone/study/advice/radiation_warnings.hpp"
#include "idiophone/study/advice/rank_prediction.hpp"
#include "idiophone/study/advice/recommendations.hpp"
#include "idiophone/study/advice/rehearsal.hpp"
#include "idiophone/study/advice/run_costs.hpp"
#include "idiophone/study/advice/run_warnings.hpp"
#include "idiophone/study/advice/sheet_places.hpp"
#include "idiophone/study/advice/step_measurement.hpp"
#include "mesh_report.hpp"
#include "rank_options.hpp"

namespace idiophone::app {

namespace {

struct CheckOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";  ///< whose free space is compared
  std::optional<double> accuracy;            ///< cents, of the recommended mesh
  std::optional<double> up_to;               ///< Hz, likewise; no mesh is recommended if both are empty
  RankOptions prediction;
  bool faces = false;  ///< lists the faces of the bodies, and does nothing else
  Style style = Style::text;
};

void declare(CLI::App& app, CheckOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_output_folder(app, options.output, "folder of the results, whose free space is compared");
  app.add_option("--accuracy", options.accuracy,
                 "cents: recommend the cheapest mesh with this accuracy of pitch (default with --up-to: 5)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_option("--up-to", options.up_to, "Hz: up to this frequency (default with --accuracy: 5000)")
      ->check(CLI::Range(1.0, 1e9));
  add_ranks(app, options.prediction);
  app.add_flag("--faces", options.faces, "list the faces of STEP, BREP, STL and OBJ parts, and do nothing else");
  add_json(app, options.style);
  app.add_flag_callback(
      "--resolved", [&options] { options.style = Style::deck; },
      "print the deck with overrides and defaults, itself a deck, and do nothing else");
}

constexpr double mega = 1e6;

/// The grid of waves. Collective.
/// @return none with other radiation models
std::optional<waves::Plan> plan_of_waves(const bodies::Preparation& ready) {
  if (ready.scene.radiation.model != scene::RadiationModel::waves) {
    return {};
  }
  return propagation::wave_plan(ready.scene, bodies::audible_surface(ready, MPI_COMM_WORLD), MPI_COMM_WORLD);
}

/// @param sample  its time of the radiation is that of waves
void report(const waves::Plan& plan, const scene::Scene& scene, const advice::RehearsedSample& sample) {
  const double samples = scene.time.duration * scene.audio.rate;
  const std::string time = sample.is_played ? fmt::format("{} for all steps ({:.3g} ms each)",
                                                          advice::duration_text(samples * sample.radiation),
                                                          1e3 * sample.radiation / plan.steps)
                                            : "the time of their steps is not known";
  spdlog::info("waves: {} x {} x {} cells of {:.4g} m, {} steps in an audio sample, about {:.0f} MB of memory",
               plan.grid.cells[0], plan.grid.cells[1], plan.grid.cells[2], plan.grid.cell, plan.steps,
               plan.bytes() / mega);
  spdlog::info("waves: levels hold up to {:.0f} Hz (10 cells a wavelength); {}",
               plan.highest_frequency(scene.radiation.air.speed), time);
}

/// What mesh is wanted, if --accuracy or --up-to is given.
std::optional<accuracy::Accuracy> wanted_accuracy(const CheckOptions& options) {
  if (!options.accuracy && !options.up_to) {
    return {};
  }
  return accuracy::Accuracy{.cents = options.accuracy.value_or(5), .frequency = options.up_to.value_or(5000)};
}

void print_json(const bodies::Preparation& ready, nlohmann::json costs,
                const std::vector<std::optional<advice::PitchEstimate>>& estimates,
                const std::vector<advice::CrossSection>& sections,
                const std::vector<std::optional<std::string>>& sheets, const std::optional<accuracy::Accuracy>& wanted,
                const std::optional<advice::RankPrediction>& prediction) {
  nlohmann::json answer = loop::size_facts(ready);
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& body = ready.scene.bodies[b];
    auto& facts = answer["bodies"][body.name];
    facts["warning"] = pitch_warning(ready, b).value_or("");
    if (estimates[b]) {
      facts["lowest_modes"] = {{"frequencies", estimates[b]->frequencies}, {"mesh_errors", estimates[b]->mesh_errors}};
    }
    facts["radiation_warning"] =
        advice::radiation_warning(body.name, ready.statistics[b], ready.scene.radiation).value_or("");
    if (const auto& limit = ready.initial_state.steps[b]; limit.is_limited()) {
      facts["processor_seconds"] = accuracy::seconds_of(ready.statistics[b], body.element, limit.step);
    }
    if (!sections.empty()) {
      facts["waves"] = {
          {"cells_across", sections[b].thickness / ready.scene.radiation.grid.cell},
          {"level_error", advice::level_error(sections[b], ready.scene.radiation.grid.cell)},
          {"fine_cell", advice::fine_cell(sections[b])},
          {"sheet_warning", sheets[b].value_or("")},
          {"opposite_parts_from",
           advice::opposite_parts_from(sections[b], ready.scene.radiation.grid.cell, ready.scene.radiation.air.speed)}};
    }
    if (wanted) {
      facts["recommended"] = advice::recommendation_facts(ready, b, *wanted);
    }
  }
  answer["costs"] = std::move(costs);
  if (prediction) {
    answer["prediction"] = advice::facts_of(*prediction);
  }
  print_answer(answer);
}

/// What stands for a rehearsal where a run does not fit into the memory.
advice::RehearsedSample motion_alone(const bodies::Preparation& ready, double step_seconds) {
  if (parallel::is_root(MPI_COMM_WORLD)) {
    spdlog::warn(
        "the run does not fit into this memory, so its first moments were not played: its time is that of the motion, "
        "without contacts and sound");
  }
  const double seconds = ready.steps_per_sample * step_seconds;
  return {.seconds = seconds, .motion = seconds, .is_played = false};
}

/// Lists the faces of all bodies. Collective.
void list_faces(const CheckOptions& options) {
  std::vector<std::string> overrides = options.overrides;
  overrides.emplace_back("loads={}");  // who looks for a place to strike has no table of forces yet
  const scene::Scene scene = bodies::read_deck(options.deck, overrides, MPI_COMM_WORLD);
  const std::vector<mesh::Mesh> meshes = bodies::read_meshes(scene, MPI_COMM_WORLD);
  parallel::on_root(MPI_COMM_WORLD, [&] {
    const nlohmann::ordered_json faces = faces_of(scene.bodies, meshes);
    options.style == Style::json ? print_answer(faces) : print_faces(faces);
  });
}

int check(const CheckOptions& options) {
  if (options.style == Style::deck) {
    parallel::on_root(MPI_COMM_WORLD, [&] { fmt::print("{}", scene::resolved_deck(options.deck, options.overrides)); });
    return loop::exit_finished;
  }
  if (options.faces) {
    list_faces(options);
    return loop::exit_finished;
  }
  const double program = loop::peak_memory();
  const double begun = advice::processor_clock();
  scene::Scene scene = bodies::read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  advice::Network network;
  if (options.prediction.ranks) {
    network = network_of(options.prediction);
    advice::require_fitting_processes(scene, *options.prediction.ranks, MPI_COMM_WORLD);
  }
  bodies::PreparedMeshes prepared = bodies::prepare_with_meshes(
      std::move(scene), MPI_COMM_WORLD, options.prediction.ranks ? bodies::ReadRows::keep : bodies::ReadRows::drop);
  const bodies::Preparation& ready = prepared.ready;
  const double preparation = parallel::largest(advice::processor_clock() - begun, MPI_COMM_WORLD);
  const advice::StepMeasurement measured = advice::measure_steps(ready, program, MPI_COMM_WORLD);
  std::optional<advice::RankPrediction> prediction;  // before the rehearsal, which needs memory of its own
  if (options.prediction.ranks) {
    prediction = advice::predict_ranks(prepared, *options.prediction.ranks, measured, network, MPI_COMM_WORLD);
  }
  const std::optional<waves::Plan> waves = plan_of_waves(ready);
  const double needed = parallel::sum(measured.memory.of(ready.part), MPI_COMM_WORLD) + (waves ? waves->bytes() : 0.0);
  const double memory = loop::memory_of_machines(MPI_COMM_WORLD);
  const double step_seconds = measured.step.whole / parallel::size_of(MPI_COMM_WORLD);
  const bool fits = needed <= memory;
  const advice::RehearsedSample sample =
      fits ? advice::rehearse(ready, step_seconds, MPI_COMM_WORLD) : motion_alone(ready, step_seconds);
  if (prediction && waves) {
    const double of_all = sample.radiation * parallel::size_of(MPI_COMM_WORLD);
    prediction->waves =
        advice::predict_waves(*waves, *options.prediction.ranks,
                              fits ? std::optional(of_all / waves->steps) : std::nullopt, prediction->network);
  }
  if (!options.prediction.exchanges.empty() && parallel::is_root(MPI_COMM_WORLD)) {
    write_exchanges(*prediction, options.prediction.exchanges);
  }
  const std::vector<advice::ContactCost> contacts =
      fits ? advice::contact_costs(ready, sample.motion / ready.steps_per_sample, MPI_COMM_WORLD)
           : advice::unknown_costs(ready.scene);
  const std::vector<std::optional<std::string>> sheets = advice::sheet_warnings(ready, MPI_COMM_WORLD);
  if (!parallel::is_root(MPI_COMM_WORLD)) {
    return loop::exit_finished;
  }
  const advice::RunCosts costs = advice::run_costs(ready, {preparation, sample, contacts}, needed, MPI_COMM_WORLD);
  const std::vector<advice::CrossSection> sections = sections_of(ready.scene, prepared.meshes);
  const std::vector<std::optional<advice::PitchEstimate>> estimates = pitch_estimates(ready, prepared.meshes);
  if (options.style == Style::json) {
    print_json(ready, advice::facts_of(costs, ready.scene, contacts), estimates, sections, sheets,
               wanted_accuracy(options), prediction);
  } else {
    report_mesh(ready);
    report_pitch(ready, estimates);
    advice::report_doubts(ready);
    if (waves) {
      report(*waves, ready.scene, sample);
      report_sections(sections, ready.scene);
      advice::print(sheets);
    }
    if (const auto wanted = wanted_accuracy(options)) {
      for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
        advice::print_recommendation(ready, b, *wanted);
      }
    }
    report(costs, ready.scene, contacts);
    if (prediction) {
      report(*prediction);
    }
  }
  loop::compare_memory(costs.memory, memory);
  loop::compare_disk(costs.disk(), options.output);
  return loop::exit_finished;
}

}  // namespace

Command check_command() {
  return make_command<CheckOptions>("check", "validate and mesh a deck; print sizes, step, memory and time", Ranks::any,
                                    declare, check);
}

}  // namespace idiophone::app
