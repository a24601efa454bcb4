#include "material_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fit_names.hpp"

namespace idiophone::fitting {

namespace {

constexpr double settled = 3e-4;  // at the end; what is left is the square of it
constexpr int most_turns = 12;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

double distance(const ElasticConstants& constants, const TurnedMaterial& a, const TurnedMaterial& b) {
  return (unknowns(constants, a) - unknowns(constants, b)).lpNorm<Eigen::Infinity>();
}

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
  const std::vector<std::string> to_fit = names_to_fit(start_, options.constants);
  constants_ = constants_and_turns(start_, to_fit);
  stages_ = stages_of_ties(constants_, start_, to_fit);
  material_ = start_;
  expected_ = expectation_of(start_);
  mesh_errors_.resize(lines_.size());
  widths_ = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(constants_.size()), infinity);
  chosen_.resize(constants_.size(), true);
  is_promised_.resize(constants_.size());
}

void MaterialFit::run(Identification& result) {
  try {
    search();
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
      look_for_equivalents(result);
      look_further(result);
    } catch (const Stopped&) {  // the constants are there; only the advice is missing
    }
  }
  tell(result);
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
  return solved_ && has_stayed(*solved_, roughly) && has_stayed(modelled_, settled);
}

/// Whether no unknown has changed by more than that since there was this material, or a turn by a small part of its
/// interval: where the lines hardly move with a turn, it goes on changing without an effect.
bool MaterialFit::has_stayed(const TurnedMaterial& before, double within) const {
  constexpr double small = 0.1;
  const Eigen::VectorXd changes = unknowns(constants_, material_) - unknowns(constants_, before);
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    const auto place = static_cast<Eigen::Index>(k);
    const double part =
        constants_[k].kind == ConstantKind::turn ? small * widths_[place] / constants_[k].unit(material_) : 0.0;
    if (std::abs(changes[place]) > std::max(within, part)) {
      return false;
    }
  }
  return true;
}

/// The modes up to all lines with the present material.
/// @param trusted  change of an unknown for which it is enough to combine the modes that were solved last
void MaterialFit::renew_model(double trusted) {
  modelled_ = material_;
  if (solved_ && distance(constants_, material_, *solved_) < trusted) {
    model_ = body_.nearby(material_);
    return;
  }
  model_ = body_.model(material_, model_up_to());
  solved_ = material_;
  note_solves(1);
}

/// The frequency up to which all modes are solved, Hz.
double MaterialFit::model_up_to() const {
  constexpr double more = 30.0;  // cents
  return highest_ * std::exp2((options_.tolerance + more) / 1200);
}

void MaterialFit::note_solves(int solves) {
  solves_ += solves;
  heed_watch();
}

void MaterialFit::heed_watch() const {
  if (!options_.watch) {
    return;
  }
  constexpr int usually = 3;  // besides those of the starts
  const int expected = std::max(usually + starting_turns(), solves_ + 1);
  std::string best;
  TurnedMaterial now = material_;
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

/// Moduli within a fifth or so of a table's, ratios within 0.1, turns within 17 degrees, or as the user says.
Expectation MaterialFit::expectation_of(const TurnedMaterial& material) const {
  Expectation expected{unknowns(constants_, material), {}};
  expected.deviation.resize(expected.middle.size());
  std::ranges::transform(constants_, expected.deviation.begin(), [&](const ElasticConstant& constant) {
    const double usual = expected_deviation(constant);
    return constant.kind == ConstantKind::turn ? options_.turn_deviation.value_or(usual) : usual;
  });
  return expected;
}

void MaterialFit::tell(Identification& result) const {
  TurnedMaterial found = material_;
  TurnedMaterial deck = start_;
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    const auto place = static_cast<Eigen::Index>(k);
    if (stages_.back().row(place).sum() > 0) {
      result.constants.push_back({.name = constants_[k].name,
                                  .value = constants_[k].in(found),
                                  .start = constants_[k].in(deck),
                                  .half_width = widths_[place],
                                  .determined = chosen_[k],
                                  .would_be_determined = is_promised_[k],
                                  .has_no_effect = has_no_effect(constants_[k])});
    }
  }
  result.material = material_;
  if (has_turns()) {
    result.grain = body_.grain_of(material_);
  }
  result.volume = body_.volume();
  result.solves = solves_;
}

}  // namespace idiophone::fitting
