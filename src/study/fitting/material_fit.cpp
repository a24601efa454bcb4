#include "material_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "confidence.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "least_squares.hpp"

namespace idiophone::fitting {

namespace {

constexpr double first_tolerance = 200.0;  // cents; halved with each solve, down to the wanted one
constexpr double largest_shift = 700.0;    // cents, by which all frequencies may be wrong at first
constexpr double undetermined = 0.1;       // 95 % half-width of ln of a modulus, or of a Poisson's ratio
constexpr double settled = 1e-7;           // change of an unknown
constexpr int most_solves = 30;

std::ptrdiff_t moduli(const ElasticConstants& constants) {
  return std::ranges::count(constants, ConstantKind::modulus, &ElasticConstant::kind);
}

}  // namespace

MaterialFit::MaterialFit(const scene::Solids& solids, const Measurements& measured,
                         const IdentificationOptions& options)
    : options_(options),
      body_(solids, options.mass),
      start_(solids.materials[solids.bodies.front().material]),
      lines_(measured.lines) {
  if (options.lines && static_cast<std::size_t>(*options.lines) < lines_.size()) {
    lines_.resize(*options.lines);
  }
  highest_ = measured.lines.back().frequency;
  if (measured.mass) {
    start_.density = *measured.mass / body_.volume();
  }
  constants_ = elastic_constants(start_, options.constants);
  material_ = start_;
}

void MaterialFit::run(Identification& result) {
  for (const ElasticConstant& constant : constants_) {
    scene::Material deck = start_;
    result.constants.push_back({.name = constant.name, .start = constant.in(deck)});
  }
  align();
  for (;;) {
    fit();
    if (constants_.empty()) {
      break;
    }
    const Eigen::VectorXd widths = half_widths(residuals_, jacobian_);
    note(widths, result);
    Eigen::Index widest = 0;
    if (widths.maxCoeff(&widest) <= undetermined) {
      break;
    }
    hold(widest, result);
  }
  result.material = material_;
  result.volume = body_.volume();
  result.solves = solves_;
}

void MaterialFit::solve(double margin) {
  model_ = body_.model(material_, margin * highest_);
  ++solves_;
}

/// Scales all moduli so that most lines have a mode nearby.
void MaterialFit::align() {
  solve(std::exp2(largest_shift / 1200));
  if (moduli(constants_) != moduli(elastic_constants(start_, {}))) {
    return;
  }
  const double shift = common_shift(lines_, *model_, material_, largest_shift);
  Eigen::VectorXd point = unknowns(constants_, material_);
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    point[k] += constants_[k].kind == ConstantKind::modulus ? shift / 600 * std::numbers::ln2 : 0.0;
  }
  material_ = with_unknowns(constants_, material_, point);
}

/// Solves and fits in turn until nothing changes.
void MaterialFit::fit() {
  constexpr double margin = 1.15;  // above the largest tolerance
  double tolerance = std::max(options_.tolerance, first_tolerance);
  for (int turn = 0;; ++turn) {
    solve(margin);
    const Eigen::VectorXd before = unknowns(constants_, material_);
    adjust(tolerance);
    const Eigen::VectorXd change = unknowns(constants_, material_) - before;
    if (tolerance <= options_.tolerance && (change.size() == 0 || change.lpNorm<Eigen::Infinity>() < settled)) {
      break;
    }
    if (turn == most_solves) {
      throw std::runtime_error(
          fmt::format("the fit has not settled after {} solves: the assignment of lines to modes changes to and fro; "
                      "try another --tolerance, or leave doubtful lines out",
                      most_solves));
    }
    tolerance = std::max(options_.tolerance, tolerance / 2);
  }
}

/// Fits with the shapes that are there. Where modes cross, matching and fitting in turn ends in one of several
/// minima: the best from starts around the present constants is taken.
void MaterialFit::adjust(double tolerance) {
  constexpr double around = 0.03;  // of ln of a modulus, or of a Poisson's ratio
  const scene::Material present = material_;
  const Eigen::VectorXd middle = unknowns(constants_, present);
  double smallest = adjust_from_here(tolerance);
  if (!std::isfinite(smallest)) {
    throw std::runtime_error(fmt::format(
        "no line is within {:g} cents of a mode of the body: are shape, size, material and constraints those of "
        "the measured body?",
        tolerance));
  }
  scene::Material best = material_;
  for (Eigen::Index k = 0; k < middle.size(); ++k) {
    for (const double change : {-around, around}) {
      material_ = with_unknowns(constants_, present, middle + change * Eigen::VectorXd::Unit(middle.size(), k));
      if (!is_stable(material_)) {
        continue;
      }
      const double cost = adjust_from_here(tolerance);
      constexpr double clearly = 1e-3;
      if (cost < smallest - clearly) {
        smallest = cost;
        best = material_;
      }
    }
  }
  material_ = best;
  static_cast<void>(adjust_from_here(tolerance));
}

/// Matches and fits in turn from the present constants. Returns the cost of the last matching; infinite if no line
/// has a mode.
double MaterialFit::adjust_from_here(double tolerance) {
  LinePairs pairs;
  constexpr int most_turns = 20;
  for (int turn = 0; turn < most_turns; ++turn) {
    const LinePairs matched = assign(lines_, *model_, material_, tolerance).pairs;
    if (matched.empty()) {
      return std::numeric_limits<double>::infinity();
    }
    if (matched == pairs) {
      break;
    }
    pairs = matched;
    if (!constants_.empty()) {
      fit_pairs(pairs);
    }
  }
  return assign(lines_, *model_, material_, tolerance).cost;
}

void MaterialFit::fit_pairs(const LinePairs& pairs) {
  const Eigen::VectorXd infinite =
      Eigen::VectorXd::Constant(constants_.size(), std::numeric_limits<double>::infinity());
  const LeastSquares found = minimize([&](const Eigen::VectorXd& point) { return residuals(pairs, point); },
                                      [&](const Eigen::VectorXd& point) { return jacobian(pairs, point); },
                                      unknowns(constants_, material_), {-infinite, infinite}, {});
  material_ = with_unknowns(constants_, material_, found.point);
  residuals_ = found.residuals;
  jacobian_ = found.jacobian;
}

/// Cents of the lines above their modes, over the uncertainties; none for a material that gains energy by strain.
std::optional<Eigen::VectorXd> MaterialFit::residuals(const LinePairs& pairs, const Eigen::VectorXd& point) const {
  const scene::Material material = with_unknowns(constants_, material_, point);
  if (!is_stable(material)) {
    return {};
  }
  const Eigen::VectorXd frequencies = model_->frequencies(material);
  Eigen::VectorXd values(pairs.size());
  std::ranges::transform(pairs, values.begin(), [&](const auto& pair) {
    const Line& line = lines_[pair.first];
    return partials::cents(line.frequency, frequencies[pair.second]) / line.uncertainty;
  });
  return values;
}

Eigen::MatrixXd MaterialFit::jacobian(const LinePairs& pairs, const Eigen::VectorXd& point) const {
  const Eigen::MatrixXd slopes = model_->cents_slopes(constants_, with_unknowns(constants_, material_, point));
  Eigen::MatrixXd values(pairs.size(), constants_.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [line, multiplet] = pairs[i];
    values.row(i) = -slopes.row(multiplet) / lines_[line].uncertainty;
  }
  return values;
}

void MaterialFit::note(const Eigen::VectorXd& widths, Identification& result) {
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    auto& constant = *std::ranges::find(result.constants, constants_[k].name, &IdentifiedConstant::name);
    constant.value = constants_[k].in(material_);
    constant.half_width = widths[k] * (constants_[k].kind == ConstantKind::modulus ? constant.value : 1.0);
  }
}

/// Gives a constant the deck's value for good.
void MaterialFit::hold(std::ptrdiff_t place, Identification& result) {
  const ElasticConstant held = constants_[place];
  auto& constant = *std::ranges::find(result.constants, held.name, &IdentifiedConstant::name);
  constant.determined = false;
  constant.value = constant.start;
  held.in(material_) = constant.start;
  constants_.erase(constants_.begin() + place);
}

}  // namespace idiophone::fitting
