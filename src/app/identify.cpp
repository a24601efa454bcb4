// `idiophone identify`: the constants of a material from measured resonances.

#include "idiophone/study/fitting/identification.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "materials_section.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

struct IdentifyOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path measured;      ///< a YAML file, or a recording
  std::string body;                    ///< empty for the first
  std::vector<std::string> constants;  ///< to fit; empty for all of the material
  double tolerance = 50.0;             ///< cents, between a line and its mode
  std::optional<int> lines;            ///< fit only so many, the lowest
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::consistent;
  Style style = Style::text;
};

void declare(CLI::App& app, IdentifyOptions& options) {
  add_deck(app, options.deck, options.overrides);
  app.add_option("--measured", options.measured,
                 "resonances, a YAML file (docs/use/identify.md), or a recording: WAV, FLAC, ...")
      ->required();
  add_body(app, options.body);
  app.add_option("--fit", options.constants,
                 "elastic constants to fit, e.g. young,poisson (default: all of the material)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--tolerance", options.tolerance, "cents between a line and its mode")->capture_default_str();
  app.add_option("--lines", options.lines, "fit only so many lines, the lowest, and predict the others")
      ->check(CLI::Range(1, 1000000));
  add_mass(app, options.mass, "consistent, or lumped, as the motion has it");
  add_json(app, options.style);
}

using fitting::AssignedLine;
using fitting::Identification;
using fitting::IdentifiedConstant;

/// "3", or "3-4" for two modes of one frequency.
std::string mode_text(int first, int count) {
  return count == 1 ? fmt::format("{}", first) : fmt::format("{}-{}", first, first + count - 1);
}

void print_constants(const Identification& found) {
  fmt::print("{:<12}  {:>12}  {:>12}  {:>12}\n", "constant", "value", "+- (95 %)", "in the deck");
  for (const IdentifiedConstant& constant : found.constants) {
    fmt::print("{:<12}  {:>12.6g}  {:>12.3g}  {:>12.6g}{}\n", constant.name, constant.value, constant.half_width,
               constant.start, constant.determined ? "" : "  not determined");
  }
}

void print_lines(const Identification& found) {
  fmt::print("\n{:>4}  {:>13}  {:>7}  {:>13}  {:>7}\n", "line", "measured/Hz", "mode", "computed/Hz", "cents");
  int number = 0;
  for (const AssignedLine& line : found.lines) {
    fmt::print("{:>4}  {:>13.3f}  ", ++number, line.line.frequency);
    if (line.modes == 0) {
      fmt::print("{:>7}  {:>13}  {:>7}\n", "-", "false line", "-");
    } else {
      fmt::print("{:>7}  {:>13.3f}  {:>+7.2f}{}\n", mode_text(line.first_mode, line.modes), line.computed, line.cents,
                 line.is_split    ? "  split"
                 : line.is_fitted ? ""
                                  : "  predicted");
    }
  }
  for (const auto& [first, count, frequency] : found.missing) {
    fmt::print("{:>4}  {:>13}  {:>7}  {:>13.3f}  {:>7}\n", "-", "not measured", mode_text(first, count), frequency,
               "-");
  }
  if (found.fitted_rms) {
    fmt::print("rms of the fitted lines: {:.2f} cents\n", *found.fitted_rms);
  }
  if (found.tested_rms) {
    fmt::print("rms of the predicted lines: {:.2f} cents\n", *found.tested_rms);
  }
}

nlohmann::json identification_facts(const Identification& found) {
  nlohmann::json answer = {{"accepted", found.doubts.empty()},
                           {"stopped", found.stopped},
                           {"doubts", found.doubts},
                           {"volume", found.volume},
                           {"density", found.material.density},
                           {"solves", found.solves},
                           {"constants", nlohmann::json::object()},
                           {"lines", nlohmann::json::array()},
                           {"not_measured", nlohmann::json::array()},
                           {"fitted_rms", loop::number_or_null(found.fitted_rms.value_or(NAN))},
                           {"predicted_rms", loop::number_or_null(found.tested_rms.value_or(NAN))},
                           {"materials", materials_section(found.material)}};
  for (const IdentifiedConstant& constant : found.constants) {
    answer["constants"][constant.name] = {{"value", constant.value},
                                          {"half_width", loop::number_or_null(constant.half_width)},
                                          {"in_the_deck", constant.start},
                                          {"determined", constant.determined}};
  }
  for (const AssignedLine& line : found.lines) {
    nlohmann::json entry = {{"measured", line.line.frequency},
                            {"mode", nullptr},
                            {"fitted", line.is_fitted},
                            {"split", line.is_split},
                            {"mesh_error", line.is_fitted ? nlohmann::json(line.mesh_error) : nlohmann::json()}};
    if (line.modes > 0) {
      entry["mode"] = line.first_mode;
      entry["modes"] = line.modes;
      entry["computed"] = line.computed;
      entry["cents"] = line.cents;
    }
    answer["lines"].push_back(entry);
  }
  for (const auto& [first, count, frequency] : found.missing) {
    answer["not_measured"].push_back({{"mode", first}, {"modes", count}, {"frequency", frequency}});
  }
  return answer;
}

void warn_of_gaps(const Identification& found) {
  for (const IdentifiedConstant& constant : found.constants) {
    if (!constant.determined) {
      spdlog::warn(
          "the lines do not determine {}: its 95 % interval would be +-{:.2g}; it keeps the deck's value. Measure more "
          "lines, or lines of other modes",
          constant.name, constant.half_width);
    }
  }
}

/// Where the mesh errs by more than the measurement.
void warn_of_the_mesh(const Identification& found) {
  const auto worst = std::ranges::max_element(found.lines, {}, &AssignedLine::mesh_error);
  if (worst->mesh_error > worst->line.uncertainty) {
    spdlog::warn(
        "the mesh may make the mode at {:.0f} Hz wrong by {:.1f} cents, and the line is known within {:g}: a finer "
        "mesh, or a higher order, makes the intervals smaller",
        worst->line.frequency, worst->mesh_error, worst->line.uncertainty);
  }
}

/// Says why the fit is not accepted. @return the exit status
int judge_fit(const Identification& found) {
  if (found.doubts.empty()) {
    return loop::exit_finished;
  }
  for (const std::string& doubt : found.doubts) {
    spdlog::error("{}", doubt);
  }
  spdlog::error(
      "the fit is not accepted: do not use these constants before you know why. Check shape, mass and supports of the "
      "body; leave out lines that may be false; or state the uncertainty of the lines");
  return found.stopped ? loop::exit_resumable : loop::exit_failed;
}

int identify(const IdentifyOptions& options) {
  if (!(options.tolerance > 0 && std::isfinite(options.tolerance))) {
    throw std::runtime_error(fmt::format("--tolerance must be above 0 cents, not {}", options.tolerance));
  }
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  scene::refuse_joints(scene, "identify");
  const std::size_t body = scene::find_body(scene.bodies, options.body);
  const fitting::Measurements measured = fitting::read_measurements(options.measured);
  if (!measured.hum.empty()) {
    spdlog::info("left out as hum of the mains: {:.2f} Hz", fmt::join(measured.hum, ", "));
  }
  const Identification found = [&] {
    loop::PieceProgress progress = search_progress(options.style);
    return fitting::identify(scene::Solids(scene).alone(body), measured,
                             {.constants = options.constants,
                              .tolerance = options.tolerance,
                              .lines = options.lines,
                              .mass = options.mass,
                              .watch = watch_by(progress)});
  }();
  warn_of_gaps(found);
  warn_of_the_mesh(found);
  if (options.style == Style::json) {
    print_answer(identification_facts(found));
  } else {
    print_constants(found);
    print_lines(found);
    fmt::print("\n{}", materials_section(found.material));
  }
  return judge_fit(found);
}

}  // namespace

Command identify_command() {
  return make_command<IdentifyOptions>("identify", "find a material's constants from measured resonances", Ranks::one,
                                       declare, identify);
}

}  // namespace idiophone::app
