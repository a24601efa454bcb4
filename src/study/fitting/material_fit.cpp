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
constexpr double nearby = 0.03;   // change of an unknown, for which solved modes still span those that are wanted
constexpr double settled = 3e-4;  // at the end; what is left is the square of it
constexpr int most_turns = 12;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The search was told to stop.
struct Stopped {};

double distance(const ElasticConstants& constants, const scene::Material& a, const scene::Material& b) {
  return (unknowns(constants, a) - unknowns(constants, b)).lpNorm<Eigen::Infinity>();
}

}  // namespace

MaterialFit::MaterialFit(StrainedBody body, const Measurements& measured, const IdentificationOptions& options)
    : options_(options),
      body_(std::move(body)),
      start_(body_.material()),
      measured_(measured.lines),
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
  is_promised_.resize(constants_.size());
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
  if (!result.stopped) {
    try {
      look_further(result);
    } catch (const Stopped&) {  // the constants are there; only the advice is missing
    }
  }
  tell(result);
}

/// From the lowest lines and modes, on a coarser mesh where that is possible, until the modes belong to about the
/// constants that they give.
void MaterialFit::begin() {
  const std::vector<Line> lowest(lines_.begin(), lines_.begin() + std::min(first_lines, lines_.size()));
  std::optional<StrainedBody> coarser = body_.coarser();
  StrainedBody& body = coarser ? *coarser : body_;
  const auto solve = [&] {
    modelled_ = material_;
    model_ = body.lowest(material_, static_cast<int>(2 * lowest.size() + 5));
    note_solve();
  };
  solve();
  find_start(lowest);
  constexpr int most_repetitions = 3;
  const FitRules rules{stages_.back(), std::max(options_.tolerance, first_tolerance / 2), &expected_};
  for (int turn = 0; turn < most_repetitions && distance(constants_, material_, modelled_) > nearby; ++turn) {
    solve();
    material_ = fit_and_match({lowest, *model_, constants_}, material_, rules).material;
  }
}

/// All moduli at once, by the likeliest common shifts of all frequencies, then more and more unknowns. The best of
/// these fits is where the search goes on.
void MaterialFit::find_start(const std::vector<Line>& lowest) {
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
    renew_model(nearby);
    const double change =
        adopt(fit_around({lowest, *model_, constants_}, material_, {stages_.back(), tolerance, &expected_}, {0.03}));
    if (count == lines_.size() && tolerance <= options_.tolerance && change < roughly) {
      break;
    }
    count = std::min(lines_.size(), 2 * count);
    tolerance = std::max(options_.tolerance, tolerance / 2);
  }
}

/// Fits the chosen constants, and solves where they have changed, until nothing changes.
void MaterialFit::settle() {
  const FitRules rules{.ties = single_ties(chosen_), .tolerance = options_.tolerance};
  for (int turn = 0; turn < most_turns && !is_settled(); ++turn) {
    renew_model(roughly);
    adopt(fit_and_match(problem(), material_, rules));
  }
}

bool MaterialFit::is_settled() const {
  return solved_ && distance(constants_, material_, *solved_) < roughly &&
         distance(constants_, material_, modelled_) < settled;
}

/// The modes up to all lines with the present material.
/// @param trusted  change of an unknown for which it is enough to combine the modes that were solved last
void MaterialFit::renew_model(double trusted) {
  modelled_ = material_;
  if (solved_ && distance(constants_, material_, *solved_) < trusted) {
    model_ = body_.nearby(material_);
    return;
  }
  constexpr double more = 30.0;  // cents
  model_ = body_.model(material_, highest_ * std::exp2((options_.tolerance + more) / 1200));
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
  constexpr int usually = 3;
  const int expected = std::max(usually, solves_ + 1);
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

/// Moduli within a fifth or so of a table's, ratios within 0.1.
Expectation MaterialFit::expectation_of(const scene::Material& material) const {
  Expectation expected{unknowns(constants_, material), {}};
  expected.deviation.resize(expected.middle.size());
  std::ranges::transform(constants_, expected.deviation.begin(), expected_deviation);
  return expected;
}

void MaterialFit::tell(Identification& result) const {
  scene::Material found = material_;
  scene::Material deck = start_;
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    const auto place = static_cast<Eigen::Index>(k);
    if (stages_.back().row(place).sum() > 0) {
      result.constants.push_back({.name = constants_[k].name,
                                  .value = constants_[k].in(found),
                                  .start = constants_[k].in(deck),
                                  .half_width = widths_[place],
                                  .determined = chosen_[k],
                                  .would_be_determined = is_promised_[k]});
    }
  }
  result.material = material_;
  result.volume = body_.volume();
  result.solves = solves_;
}

}  // namespace idiophone::fitting
