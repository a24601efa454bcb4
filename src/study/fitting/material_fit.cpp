#include "material_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace idiophone::fitting {

namespace {

constexpr std::size_t first_lines = 20;    // of a fit, the lowest; twice as many with each solve
constexpr double first_tolerance = 200.0;  // cents; halved with each solve, down to the wanted one
constexpr double largest_shift = 1000.0;   // cents, by which all frequencies may be wrong at first
constexpr double roughly = 3e-3;           // change of an unknown, before the constants are chosen
constexpr double settled = 3e-4;           // at the end; what is left is the square of it
constexpr int most_turns = 12;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The search was told to stop.
struct Stopped {};

double distance(const ElasticConstants& constants, const scene::Material& a, const scene::Material& b) {
  return (unknowns(constants, a) - unknowns(constants, b)).lpNorm<Eigen::Infinity>();
}

}  // namespace

MaterialFit::MaterialFit(const scene::Solids& solids, const Measurements& measured,
                         const IdentificationOptions& options)
    : options_(options),
      body_(solids, options.mass),
      start_(solids.materials[solids.bodies.front().material]),
      lines_(measured.lines),
      highest_(measured.lines.back().frequency) {
  if (options.lines && static_cast<std::size_t>(*options.lines) < lines_.size()) {
    lines_.resize(*options.lines);
  }
  if (measured.mass) {
    start_.density = *measured.mass / body_.volume();
  }
  static_cast<void>(elastic_constants(start_, options.constants));  // refuses unknown names
  constants_ = elastic_constants(start_, {});
  stages_ = stages_of_ties(constants_, start_, options.constants);
  material_ = start_;
  expected_ = expectation_of(start_);
  mesh_errors_.resize(lines_.size());
  widths_ = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(constants_.size()), infinity);
  chosen_.resize(constants_.size(), true);
}

void MaterialFit::run(Identification& result) {
  try {
    begin();
    refine();
    choose();
    weigh();
    settle();
  } catch (const Stopped&) {
    result.stopped = true;
    result.doubts.push_back(
        fmt::format("stopped after {} eigenvalue problems: the constants are the best ones so far", solves_));
  }
  if (!result.stopped && !is_settled()) {
    result.doubts.emplace_back(
        "the fit has not settled: the assignment of lines to modes changes to and fro; try another --tolerance, or "
        "leave doubtful lines out");
  }
  tell(result);
}

/// From the lowest lines and modes: all moduli at once, by the likeliest common shifts of all frequencies, then more
/// and more unknowns. The best of these fits is where the search goes on.
void MaterialFit::begin() {
  const std::vector<Line> lowest(lines_.begin(), lines_.begin() + std::min(first_lines, lines_.size()));
  model_ = body_.lowest(start_, static_cast<int>(2 * lowest.size() + 5));
  solved_ = start_;
  note_solve();
  const FitProblem problem{lowest, *model_, constants_};
  constexpr double judging = 100.0;  // cents
  double smallest = infinity;
  for (const double shift : likely_shifts(lowest)) {
    scene::Material material = with_unknowns(
        constants_, start_, unknowns(constants_, start_) + shift / 600 * std::numbers::ln2 * stages_.front().col(0));
    const Expectation expected = expectation_of(material);
    for (const Ties& ties : stages_) {
      const double tolerance = std::max(options_.tolerance, first_tolerance);
      material = fit_around(problem, material, {ties, tolerance, &expected}, {0.03, 0.1}).material;
    }
    const Assignment matched = assign(lowest, *model_, material, judging);
    if (!matched.pairs.empty() && matched.cost < smallest) {
      smallest = matched.cost;
      material_ = material;
      expected_ = expected;
    }
  }
  if (!std::isfinite(smallest)) {
    throw std::runtime_error(fmt::format(
        "no line is within {:g} cents of a mode of the body, even if all are shifted: are shape, size, material and "
        "constraints those of the measured body?",
        judging));
  }
}

/// Solves and fits in turn, with more lines and a smaller tolerance each time. All constants may change, and the
/// expected values hold those that the lines hardly move.
void MaterialFit::refine() {
  double tolerance = std::max(options_.tolerance, first_tolerance / 2);
  std::size_t count = std::min(lines_.size(), 2 * first_lines);
  for (int turn = 0; turn < most_turns; ++turn) {
    const std::vector<Line> lowest(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(count));
    solve_up_to(lowest.back().frequency, tolerance);
    const double change =
        adopt(fit_around({lowest, *model_, constants_}, material_, {stages_.back(), tolerance, &expected_}, {0.03}));
    if (count == lines_.size() && tolerance <= options_.tolerance && change < roughly) {
      break;
    }
    count = std::min(lines_.size(), 2 * count);
    tolerance = std::max(options_.tolerance, tolerance / 2);
  }
}

/// Solves and fits the chosen constants in turn until nothing changes.
void MaterialFit::settle() {
  const FitRules rules{.ties = single_ties(chosen_), .tolerance = options_.tolerance};
  for (int turn = 0; turn < most_turns && !is_settled(); ++turn) {
    solve_up_to(highest_, options_.tolerance);
    adopt(fit_and_match(problem(), material_, rules));
  }
}

bool MaterialFit::is_settled() const {
  return covered_ >= highest_ && distance(constants_, material_, solved_) < settled;
}

/// @param tolerance  cents, of lines from their modes
void MaterialFit::solve_up_to(double highest, double tolerance) {
  constexpr double more = 30.0;  // cents
  covered_ = highest * std::exp2((tolerance + more) / 1200);
  model_ = body_.model(material_, covered_);
  solved_ = material_;
  note_solve();
}

void MaterialFit::note_solve() {
  ++solves_;
  heed_watch();
}

void MaterialFit::heed_watch() const {
  if (!options_.watch) {
    return;
  }
  const double doublings = std::log2(static_cast<double>(lines_.size()) / (2 * first_lines));
  const int expected = std::max(5 + std::max(0, static_cast<int>(std::ceil(doublings))), solves_ + 1);
  std::string best;
  scene::Material now = material_;
  for (const ElasticConstant& constant : constants_) {
    best += fmt::format("{}{} {:.4g}", best.empty() ? "" : ", ", constant.name, constant.in(now));
  }
  if (!options_.watch({solves_, expected, best})) {
    throw Stopped();
  }
}

/// @return the largest change of an unknown
double MaterialFit::adopt(const MatchedFit& fit) {
  if (fit.pairs.empty()) {
    throw std::runtime_error(fmt::format(
        "no line is within {:g} cents of a mode of the body: are shape, size, material and constraints those of the "
        "measured body?",
        options_.tolerance));
  }
  const double change = distance(constants_, fit.material, material_);
  material_ = fit.material;
  pairs_ = fit.pairs;
  return change;
}

/// The common shifts of all frequencies to begin with, the likeliest first; none where not all moduli may change.
std::vector<double> MaterialFit::likely_shifts(const std::vector<Line>& lines) const {
  constexpr int most = 3;
  const auto moduli = std::ranges::count(constants_, ConstantKind::modulus, &ElasticConstant::kind);
  return stages_.front().sum() == static_cast<double>(moduli)
             ? common_shifts(lines, *model_, start_, largest_shift, most)
             : std::vector{0.0};
}

/// Moduli within a fifth or so of a table's, Poisson's ratios within 0.1.
Expectation MaterialFit::expectation_of(const scene::Material& material) const {
  constexpr double of_moduli = 0.2;
  constexpr double of_ratios = 0.1;
  Expectation expected{unknowns(constants_, material), {}};
  expected.deviation.resize(expected.middle.size());
  std::ranges::transform(constants_, expected.deviation.begin(), [](const ElasticConstant& constant) {
    return constant.kind == ConstantKind::modulus ? of_moduli : of_ratios;
  });
  return expected;
}

void MaterialFit::tell(Identification& result) const {
  scene::Material found = material_;
  scene::Material deck = start_;
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    const auto place = static_cast<Eigen::Index>(k);
    if (stages_.back().row(place).sum() > 0) {
      const double value = constants_[k].in(found);
      const double unit = constants_[k].kind == ConstantKind::modulus ? value : 1.0;
      result.constants.push_back({.name = constants_[k].name,
                                  .value = value,
                                  .start = constants_[k].in(deck),
                                  .half_width = widths_[place] * unit,
                                  .determined = chosen_[k]});
    }
  }
  result.material = material_;
  result.volume = body_.volume();
  result.solves = solves_;
}

}  // namespace idiophone::fitting
