// `idiophone bench`: where, how wide and how deep to cut next, so that the partials of a body come to their targets.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "answer.hpp"
#include "bench_answer.hpp"
#include "command.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/study/bench/bench_page.hpp"
#include "idiophone/study/bench/cut_list.hpp"
#include "idiophone/study/bench/workpiece.hpp"
#include "idiophone/study/fitting/lines_of_modes.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "target_options.hpp"

namespace idiophone::app {

namespace {

struct BenchOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::string body;  ///< empty for the first
  TargetOptions target;
  std::filesystem::path measured;  ///< a YAML file, or a recording; empty for none
  double match = 100.0;            ///< cents, between a line and its mode
  std::filesystem::path cuts;      ///< that were made; empty for none
  std::vector<std::string> tools = {"router:0.006", "sander:0.02"};
  std::string side;            ///< empty for the one below
  std::filesystem::path page;  ///< to write, if any
  bench::PlanOptions plan;
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::consistent;
  Style style = Style::text;
};

void declare(CLI::App& app, BenchOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_target(app, options.target);
  app.add_option("--measured", options.measured,
                 "a recording of a tap, or a YAML file of lines (docs/use/identify.md)");
  app.add_option("--cuts", options.cuts, "a YAML file of the cuts that were made since the deck's mesh")
      ->check(CLI::ExistingFile);
  app.add_option("--match", options.match, "cents between a measured line and its mode")->capture_default_str();
  app.add_option("--tools", options.tools, "NAME:RADIUS,...: router or sander, and half the width of its cuts in m")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  app.add_option("--side", options.side, "that is cut: -z, +z, -x, ... (default: the one below)");
  app.add_option("--tolerance", options.plan.tolerance, "cents, within which a partial is in tune")
      ->capture_default_str();
  app.add_option("--deepest", options.plan.deepest, "m, of one cut")->capture_default_str();
  app.add_option("--depth-error", options.plan.depth_error, "m, standard deviation of the depth of a cut")
      ->capture_default_str();
  app.add_option("--slope-error", options.plan.slope_error,
                 "standard deviation of what a cut does, over what the model says")
      ->capture_default_str();
  add_body(app, options.body);
  add_mass(app, options.mass, "consistent, or lumped, as the motion has it");
  add_output_file(app, options.page, "a web page to write");
  add_json(app, options.style);
}

void require_above_zero(const char* name, double value) {
  if (!(value > 0 && std::isfinite(value))) {
    throw std::runtime_error(fmt::format("{} must be above 0, not {}", name, value));
  }
}

void check_bench(const BenchOptions& options) {
  require_above_zero("--match", options.match);
  require_above_zero("--tolerance", options.plan.tolerance);
  require_above_zero("--deepest", options.plan.deepest);
  require_above_zero("--depth-error", options.plan.depth_error);
  require_above_zero("--slope-error", options.plan.slope_error);
}

/// The line of each mode; none without a measurement.
std::vector<std::optional<fitting::Line>> measured_lines(const BenchOptions& options,
                                                         const std::vector<eigenmodes::Mode>& modes) {
  if (options.measured.empty()) {
    return std::vector<std::optional<fitting::Line>>(modes.size());
  }
  std::vector<double> frequencies;
  std::ranges::transform(modes, std::back_inserter(frequencies), &eigenmodes::Mode::frequency);
  return fitting::lines_of_modes(frequencies, fitting::read_measurements(options.measured).lines, options.match).lines;
}

/// Lines keep the order of the modes, which can be wrong where two modes of different kinds are nearly as high.
/// @param number  of the mode in the uncut body
void warn_of_neighbours(const std::vector<eigenmodes::Mode>& modes, std::size_t mode, int number,
                        const fitting::Line& line) {
  constexpr double close = 50.0;  // cents, by which wood moves torsion against bending
  for (std::size_t other = 0; other < modes.size(); ++other) {
    const double apart = std::abs(partials::cents(modes[other].frequency, modes[mode].frequency));
    if (other != mode && apart < close) {
      spdlog::warn(
          "another mode is computed {:.0f} cents from mode {}, so the line at {:.2f} Hz may be that of the other one. "
          "Tap where only mode {} moves, or give its line in a YAML file",
          apart, number, line.frequency, number);
    }
  }
}

/// The partials of the target, without what they are to become.
std::vector<BenchPartial> partials_of(const BenchOptions& options, const std::vector<int>& numbers,
                                      const bench::Workpiece::Solved& body) {
  const std::vector<eigenmodes::Mode>& modes = body.modes;
  const auto lines = measured_lines(options, modes);
  std::vector<BenchPartial> partials;
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    const int number = numbers[p];
    const std::size_t mode = body.tuned[p];
    if (!options.measured.empty() && !lines[mode]) {
      throw std::runtime_error(
          fmt::format("{}: mode {}, computed at {:.1f} Hz, was not measured. Tap where it moves much, give its line in "
                      "a YAML file, correct the deck by `identify`, or allow more by --match",
                      options.measured.string(), number, modes[mode].frequency));
    }
    if (lines[mode]) {
      warn_of_neighbours(modes, mode, number, *lines[mode]);
    }
    partials.push_back({.mode = number, .computed = modes[mode].frequency, .line = lines[mode]});
  }
  return partials;
}

void set_wanted(std::vector<BenchPartial>& partials, const fitting::Target& target) {
  const double unit = target.are_ratios ? partials.front().frequency() / target.values.front() : 1.0;
  for (std::size_t p = 0; p < partials.size(); ++p) {
    partials[p].wanted = unit * target.values[p];
  }
}

/// How far the partials are from their targets, for the plan.
bench::Partials distances_of(const std::vector<BenchPartial>& partials, bool are_ratios) {
  const auto count = static_cast<Eigen::Index>(partials.size());
  bench::Partials result{Eigen::VectorXd(count), Eigen::VectorXd(count), are_ratios};
  for (Eigen::Index p = 0; p < count; ++p) {
    const BenchPartial& partial = partials[static_cast<std::size_t>(p)];
    result.cents[p] = partials::cents(partial.frequency(), partial.wanted);
    result.uncertainties[p] = partial.line ? partial.line->uncertainty : 0.0;
  }
  return result;
}

void require_on_body(const std::vector<bench::Cut>& made, const bench::Strips& strips,
                     const std::filesystem::path& file) {
  for (std::size_t cut = 0; cut < made.size(); ++cut) {
    if (made[cut].place < strips.low() || made[cut].place > strips.high()) {
      throw std::runtime_error(
          fmt::format("{}: the middle of cut {} is at {:g} m, but the body lies from {:.4g} to {:.4g} m", file.string(),
                      cut + 1, made[cut].place, strips.low(), strips.high()));
    }
  }
}

int run_bench(const BenchOptions& options) {
  check_bench(options);
  const fitting::Target target = target_of(options.target);
  const std::vector<int> numbers = modes_to_tune(options.target, target);
  const std::vector<bench::Tool> tools = bench::read_tools(options.tools);
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  scene::refuse_joints(scene, "bench");
  const scene::Solids solids = scene::Solids(scene).alone(scene::find_body(scene.bodies, options.body));
  const bench::Workpiece piece(solids, options.side, numbers, options.mass);
  const std::vector<bench::Cut> made =
      options.cuts.empty() ? std::vector<bench::Cut>{} : bench::read_cuts(options.cuts, piece.side());
  const bench::Workpiece::Solved body = piece.with(made);
  std::vector<BenchPartial> partials = partials_of(options, numbers, body);
  set_wanted(partials, target);
  const bench::CutModel model = piece.model(made, body);
  const bench::Strips strips = model({}).strips;
  require_on_body(made, strips, options.cuts);
  const bench::Plan plan = bench::plan_cuts(model, tools, distances_of(partials, target.are_ratios), options.plan);
  const BenchAnswer answer{solids.bodies.front().name, partials, piece.side(), strips, tools, made, plan};
  if (options.style == Style::json) {
    print_answer(to_json(answer));
  } else {
    print(answer);
  }
  if (!options.page.empty()) {
    web::write_page(options.page.string(), bench::page(to_json(answer), body.mesh, piece.removal_of(body)));
  }
  return loop::exit_finished;
}

}  // namespace

Command bench_command() {
  return make_command<BenchOptions>("bench", "find the next cuts that bring the partials of a body to their targets",
                                    Ranks::one, declare, run_bench);
}

}  // namespace idiophone::app
