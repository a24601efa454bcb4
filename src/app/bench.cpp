// `idiophone bench`: where, how wide and how deep to cut next, so that the partials of a body come to their targets.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "answer.hpp"
#include "bench_answer.hpp"
#include "bench_session.hpp"
#include "command.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/study/bench/bench_page.hpp"
#include "idiophone/study/bench/cut_drawing.hpp"
#include "idiophone/study/bench/cut_list.hpp"
#include "idiophone/study/bench/workpiece.hpp"
#include "target_options.hpp"

namespace idiophone::app {

namespace {

struct BenchOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::string body;  ///< empty for the first
  TargetOptions target;
  std::filesystem::path measured;  ///< a YAML file, or a recording; empty for none
  std::vector<double> tapped_at;   ///< [3] m; empty where it is unknown
  double match = 60.0;             ///< cents, between a line and its mode
  std::filesystem::path cuts;      ///< that were made; empty for none
  std::vector<std::string> tools = {"router:0.006", "sander:0.02"};
  std::string side;               ///< empty for the one below
  std::filesystem::path page;     ///< to write, if any
  std::filesystem::path drawing;  ///< to write, if any
  bench::PlanOptions plan;
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::consistent;
  Style style = Style::text;
};

void declare(CLI::App& app, BenchOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_target(app, options.target);
  app.add_option("--measured", options.measured,
                 "a recording of a tap, or a YAML file of lines (docs/use/identify.md)");
  app.add_option("--tapped-at", options.tapped_at, "X,Y,Z: where the body was struck, m")
      ->delimiter(',')
      ->expected(3)
      ->needs("--measured");
  app.add_option("--cuts", options.cuts, "a YAML file of the cuts and taps since the deck's mesh")
      ->check(CLI::ExistingFile);
  app.add_option("--match", options.match,
                 "cents from a mode, beside what all modes share, from which on a line needs another tap; none counts "
                 "at twice this")
      ->capture_default_str();
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
  app.add_option("--visits", options.plan.most_visits, "visits that are planned: the next one, and later ones")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  add_body(app, options.body);
  add_mass(app, options.mass, "consistent, or lumped, as the motion has it");
  add_output_file(app, options.page, "a web page to write");
  app.add_option("--dxf", options.drawing, "a DXF drawing of the body in side view, with its cuts, to write");
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
  if (!std::ranges::all_of(options.tapped_at, [](double metres) { return std::isfinite(metres); })) {
    throw std::runtime_error("--tapped-at must be three finite numbers, in m");
  }
}

/// What is done on a body so far, with the tap of this call.
bench::Past past_of(const BenchOptions& options, const mesh::Mesh& mesh, const bench::Side& side) {
  bench::Past past;
  if (!options.cuts.empty()) {
    past = bench::read_past(options.cuts, side, bench::ends_along(mesh, side));
  }
  if (!options.measured.empty()) {
    past.taps.push_back({fitting::read_measurements(options.measured).lines, past.cuts.size(), {}});
    if (!options.tapped_at.empty()) {
      bench::Tap& tap = past.taps.back();
      tap.at = Vector3::Map(options.tapped_at.data());
      tap.lines = bench::without_faint_neighbours(tap.lines);
    }
  } else if (!past.taps.empty() && past.taps.back().cuts < past.cuts.size()) {
    throw std::runtime_error(
        fmt::format("{} has taps, but none after its last cut: give one by --measured", options.cuts.string()));
  }
  return past;
}

/// What is believed before any tap. A line that is --match away from its mode is a surprise: three standard deviations.
bench::Beliefs beliefs_of(const BenchOptions& options) {
  return {options.match / 3, options.plan.depth_error, options.plan.slope_error};
}

/// Doubts tools that are narrower than the model bears, and says so.
void warn_of_narrow_tools(std::vector<bench::Tool>& tools, const bench::Workpiece& piece) {
  for (const bench::Tool& tool : bench::doubt_narrow_tools(tools, piece.thinnest())) {
    spdlog::warn(
        "{}:{:g} cuts {:.1f} mm wide, and the body is {:.1f} mm thick: the model is not exact for such cuts. "
        "The slope error of the tool counts as {:g} at least, so its cuts are shallower",
        tool.name, tool.radius, 2e3 * tool.radius, 1e3 * piece.thinnest(), tool.slope_error);
  }
}

/// Cuts with the slope errors of their tools.
std::vector<bench::Cut> doubted(std::vector<bench::Cut> cuts, const bench::Workpiece& piece) {
  for (bench::Cut& cut : cuts) {
    cut.tool.slope_error = bench::doubt_of(cut.tool, piece.thinnest());
  }
  return cuts;
}

/// The body as it is by the cuts that were asked for, and as it shall be.
void write_drawing(const BenchOptions& options, const bench::Workpiece& piece, const BenchAnswer& answer) {
  if (options.drawing.empty()) {
    return;
  }
  std::vector<bench::Cut> cuts = answer.past.cuts;
  const mesh::Mesh& mesh = piece.uncut().mesh;
  std::vector<bench::Layer> layers = {{"BODY", bench::profile_of(mesh, piece.side(), cuts)}};
  if (!answer.plan.visits.empty()) {
    const std::vector<bench::Cut>& next = answer.plan.visits.front().cuts;
    cuts.insert(cuts.end(), next.begin(), next.end());
    layers.push_back({"NEXT", bench::profile_of(mesh, piece.side(), cuts)});
  }
  if (!(std::ofstream(options.drawing) << bench::dxf_of(layers)).flush()) {
    throw std::runtime_error(fmt::format("can't write {}", options.drawing.string()));
  }
}

/// Says why there are no cuts to make. @return the exit status
int judge(const BenchAnswer& answer) {
  if (answer.plan.verdict == bench::Verdict::in_tune || answer.plan.verdict == bench::Verdict::cut) {
    return loop::exit_finished;
  }
  spdlog::error("there are no cuts to make: {}", word_of(answer.plan.verdict));
  return loop::exit_failed;
}

int run_bench(const BenchOptions& options) {
  check_bench(options);
  const fitting::Target target = target_of(options.target);
  const std::vector<int> numbers = modes_to_tune(options.target, target);
  std::vector<bench::Tool> tools = bench::read_tools(options.tools);
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  scene::refuse_joints(scene, "bench");
  const scene::Solids solids = scene::Solids(scene).alone(scene::find_body(scene.bodies, options.body));
  mesh::Mesh mesh = mesh::read_mesh(solids.bodies.front());
  const bench::Side side = bench::read_side(options.side, mesh);
  const auto [low, high] = bench::ends_along(mesh, side);
  bench::require_suitable_radii(tools, high - low);
  const bench::Past past = past_of(options, mesh, side);
  bench::Workpiece piece(solids, std::move(mesh), side, numbers, options.mass);
  warn_of_narrow_tools(tools, piece);
  const BenchSession session = begin_session(
      piece, {numbers, options.measured.empty() ? options.cuts : options.measured}, past, target, beliefs_of(options));
  const bench::Workpiece::Slopes slopes = piece.slopes_of(session.body, session.body.tuned);
  const bench::CutModel model = piece.model(session.cuts, session.body, slopes.strips);
  const bench::Partials partials = distances_of(session.partials, target.are_ratios);
  const bench::Plan plan = session.doubt.empty()
                               ? bench::plan_cuts(model, tools, partials, options.plan, doubted(past.cuts, piece))
                               : bench::ambiguous_plan(partials, options.plan);
  const BenchAnswer answer{solids.bodies.front().name, session, piece.side(), slopes.strips, tools, past, plan};
  if (options.style == Style::json) {
    print_answer(to_json(answer));
  } else {
    print(answer);
  }
  if (!options.page.empty()) {
    web::write_page(options.page.string(), bench::page(to_json(answer), session.body.mesh, slopes.removal));
  }
  write_drawing(options, piece, answer);
  return judge(answer);
}

}  // namespace

Command bench_command() {
  return make_command<BenchOptions>("bench", "find the next cuts that bring the partials of a body to their targets",
                                    Ranks::one, declare, run_bench);
}

}  // namespace idiophone::app
