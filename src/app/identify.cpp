// `idiophone identify`: the constants of a material from measured resonances.

#include "idiophone/study/fitting/identification.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "answer.hpp"
#include "command.hpp"
#include "identification_answer.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

struct IdentifyOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path measured;        ///< a YAML file, or a recording
  std::string body;                      ///< empty for the first
  std::vector<std::string> constants;    ///< and turns to fit; empty for all constants of the material
  double tolerance = 50.0;               ///< cents, between a line and its mode
  std::optional<int> lines;              ///< fit only so many, the lowest
  std::optional<double> turn_deviation;  ///< degrees, of each turn beforehand
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
                 "elastic constants to fit, e.g. young,poisson (default: constants, all of the material); and turns of "
                 "its axes: turn_x,turn_y,turn_z, or turns")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--tolerance", options.tolerance, "cents between a line and its mode")->capture_default_str();
  app.add_option("--lines", options.lines, "fit only so many lines, the lowest, and predict the others")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--turn-deviation", options.turn_deviation,
                 "degrees, expected standard deviation of each turn; the search begins within twice that "
                 "(default: 17)")
      ->check(CLI::Range(0.1, 45.0));
  add_mass(app, options.mass, "consistent, or lumped, as the motion has it");
  add_json(app, options.style);
}

std::optional<double> in_radians(std::optional<double> degrees) {
  return degrees ? std::optional(*degrees * std::numbers::pi / 180) : std::nullopt;
}

using fitting::AssignedLine;
using fitting::Identification;
using fitting::IdentifiedConstant;

/// What the lines of this specimen can tell of a constant that those that were measured do not determine.
std::string advice_on_lines(const Identification& found, const IdentifiedConstant& constant) {
  if (found.looked_up_to == 0) {
    return "Measure more lines, or lines of other modes";
  }
  if (constant.would_be_determined) {
    return "The further lines that are named would determine it";
  }
  if (std::ranges::find(found.further, constant.name, &fitting::FurtherLine::constant) != found.further.end()) {
    return "The further lines that are named for it tell more of it, but not enough: measure several";
  }
  return fmt::format("No single line up to {:.0f} Hz would tell much more of it: measure several", found.looked_up_to);
}

/// What to measure for a constant that the lines do not determine.
std::string advice(const Identification& found, const IdentifiedConstant& constant) {
  std::string of_lines = advice_on_lines(found, constant);
  if (found.looked_up_to == 0 || constant.would_be_determined) {
    return of_lines;
  }
  const auto size = std::ranges::find(found.sizes, constant.name, &fitting::FurtherSize::constant);
  if (size == found.sizes.end()) {
    return of_lines + ", or a body of another shape";
  }
  return of_lines + (size->is_determined ? ", or the other specimen that is named, which would determine it"
                                         : ", or the other specimen that is named, which tells more of it");
}

void warn_of_gaps(const Identification& found) {
  for (const IdentifiedConstant& constant : found.constants) {
    if (constant.has_no_effect) {
      spdlog::warn("no line depends on {}: the material is the same in all directions around this axis", constant.name);
    } else if (!constant.determined) {
      spdlog::warn("the lines do not determine {}: its 95 % interval would be +-{:.2g}; it keeps the deck's value. {}",
                   constant.name, constant.half_width, advice(found, constant));
    }
  }
}

void warn_of_refused_sizes(const Identification& found) {
  for (const std::string& size : found.refused_sizes) {
    spdlog::warn("another size of the specimen was not looked at, {}", size);
  }
}

/// Lines tell moduli over the density alone. Says which density they are for where the body was not weighed.
void warn_of_the_density(const Identification& found) {
  const auto is_modulus = [](const IdentifiedConstant& constant) {
    return constant.determined && !constant.name.starts_with("poisson") && !constant.name.starts_with("turn");
  };
  if (std::ranges::any_of(found.constants, is_modulus)) {
    spdlog::warn(
        "the mass was not measured: the moduli are those for the deck's density of {:.4g} kg/m3, with which the body "
        "weighs {:.4g} kg. They are proportional to it, and their intervals leave it out. Weigh the body, and give its "
        "mass beside the lines",
        found.material.density, found.material.density * found.volume);
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
  const bool has_turns =
      std::ranges::any_of(options.constants, [](const std::string& name) { return name.starts_with("turn"); });
  if (options.turn_deviation && !has_turns) {
    throw std::runtime_error("--turn-deviation needs turns to fit, for example --fit constants,turns");
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
                              .turn_deviation = in_radians(options.turn_deviation),
                              .mass = options.mass,
                              .watch = watch_by(progress)});
  }();
  warn_of_gaps(found);
  warn_of_refused_sizes(found);
  warn_of_the_mesh(found);
  if (!measured.mass) {
    warn_of_the_density(found);
  }
  if (options.style == Style::json) {
    print_answer(identification_facts(found));
  } else {
    print(found, scene.bodies[body].name);
  }
  return judge_fit(found);
}

}  // namespace

Command identify_command() {
  return make_command<IdentifyOptions>("identify", "find a material's constants from measured resonances", Ranks::one,
                                       declare, identify);
}

}  // namespace idiophone::app
