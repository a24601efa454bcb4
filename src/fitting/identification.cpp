#include "idiophone/fitting/identification.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "confidence.hpp"
#include "fit_damping.hpp"
#include "idiophone/analysis/compare.hpp"
#include "least_squares.hpp"
#include "match.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {

namespace {

constexpr double first_tolerance = 200.0;  // cents; halved with each solve, down to the wanted one
constexpr double largest_shift = 700.0;    // cents, by which all frequencies may be wrong at first
constexpr double undetermined = 0.1;       // 95 % half-width of ln of a modulus, or of a Poisson's ratio
constexpr double settled = 1e-7;           // change of an unknown
constexpr int most_solves = 30;

std::vector<double> frequencies_of(const std::vector<Line>& lines) {
  std::vector<double> frequencies;
  std::ranges::transform(lines, std::back_inserter(frequencies), &Line::frequency);
  return frequencies;
}

/// Multiplets by ascending frequency, which is not the model's order with every material.
struct Spectrum {
  std::vector<std::size_t> multiplets;
  std::vector<Candidate> candidates;
};

Spectrum spectrum_of(const FrequencyModel& model, const scene::Material& material) {
  const Eigen::VectorXd frequencies = model.frequencies(material);
  Spectrum spectrum;
  spectrum.multiplets.resize(model.multiplets().size());
  std::iota(spectrum.multiplets.begin(), spectrum.multiplets.end(), 0);
  std::ranges::sort(spectrum.multiplets, {}, [&](std::size_t m) { return frequencies[m]; });
  for (const std::size_t m : spectrum.multiplets) {
    spectrum.candidates.push_back({frequencies[m], model.multiplets()[m].count});
  }
  return spectrum;
}

/// Pairs of a line and a multiplet.
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs match_lines(const std::vector<Line>& lines, const FrequencyModel& model, const scene::Material& material,
                  double tolerance) {
  const Spectrum spectrum = spectrum_of(model, material);
  const Matching matching = match(frequencies_of(lines), spectrum.candidates, tolerance);
  Pairs pairs;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (matching.candidate[l]) {
      pairs.emplace_back(l, spectrum.multiplets[*matching.candidate[l]]);
    }
  }
  return pairs;
}

/// Cents by which all computed frequencies must rise to match best.
double common_shift(const std::vector<Line>& lines, const std::vector<Candidate>& candidates) {
  constexpr double stride = 10.0;
  constexpr double tolerance = 100.0;
  double best = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  for (double size = 0.0; size <= largest_shift; size += stride) {
    for (const double shift : {size, -size}) {
      std::vector<Candidate> shifted = candidates;
      for (Candidate& candidate : shifted) {
        candidate.frequency *= std::exp2(shift / 1200);
      }
      const double cost = match(frequencies_of(lines), shifted, tolerance).cost;
      if (cost < smallest) {
        smallest = cost;
        best = shift;
      }
    }
  }
  return best;
}

/// A fit in progress.
class MaterialFit {
 public:
  MaterialFit(const scene::Scene& scene, const Measurements& measured, const IdentificationOptions& options)
      : options_(options),
        body_(scene, options.mass),
        start_(scene.materials[scene.bodies.front().material]),
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

  /// Fits until all constants left are determined.
  void run(Identification& result) {
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

  [[nodiscard]] const scene::Material& material() const { return material_; }
  [[nodiscard]] const FrequencyModel& model() const { return *model_; }
  [[nodiscard]] std::size_t fitted_lines() const { return lines_.size(); }

 private:
  void solve(double margin) {
    model_ = body_.model(material_, margin * highest_);
    ++solves_;
  }

  /// Scales all moduli so that most lines have a mode nearby.
  void align() {
    solve(std::exp2(largest_shift / 1200));
    const bool scales =
        std::ranges::count(constants_, ConstantKind::modulus, &ElasticConstant::kind) ==
        std::ranges::count(elastic_constants(start_, {}), ConstantKind::modulus, &ElasticConstant::kind);
    if (!scales) {
      return;
    }
    const double shift = common_shift(lines_, spectrum_of(*model_, material_).candidates);
    Eigen::VectorXd point = unknowns(constants_, material_);
    for (std::size_t k = 0; k < constants_.size(); ++k) {
      point[k] += constants_[k].kind == ConstantKind::modulus ? shift / 600 * std::numbers::ln2 : 0.0;
    }
    material_ = with_unknowns(constants_, material_, point);
  }

  /// Solves and fits in turn until nothing changes.
  void fit() {
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
  void adjust(double tolerance) {
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
  double adjust_from_here(double tolerance) {
    Pairs pairs;
    constexpr int most_turns = 20;
    for (int turn = 0; turn < most_turns; ++turn) {
      const Pairs matched = match_lines(lines_, *model_, material_, tolerance);
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
    return match(frequencies_of(lines_), spectrum_of(*model_, material_).candidates, tolerance).cost;
  }

  void fit_pairs(const Pairs& pairs) {
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
  [[nodiscard]] std::optional<Eigen::VectorXd> residuals(const Pairs& pairs, const Eigen::VectorXd& point) const {
    const scene::Material material = with_unknowns(constants_, material_, point);
    if (!is_stable(material)) {
      return {};
    }
    const Eigen::VectorXd frequencies = model_->frequencies(material);
    Eigen::VectorXd values(pairs.size());
    std::ranges::transform(pairs, values.begin(), [&](const auto& pair) {
      const Line& line = lines_[pair.first];
      return analysis::cents(line.frequency, frequencies[pair.second]) / line.uncertainty;
    });
    return values;
  }

  [[nodiscard]] Eigen::MatrixXd jacobian(const Pairs& pairs, const Eigen::VectorXd& point) const {
    const Eigen::MatrixXd slopes = model_->cents_slopes(constants_, with_unknowns(constants_, material_, point));
    Eigen::MatrixXd values(pairs.size(), constants_.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [line, multiplet] = pairs[i];
      values.row(i) = -slopes.row(multiplet) / lines_[line].uncertainty;
    }
    return values;
  }

  void note(const Eigen::VectorXd& widths, Identification& result) {
    for (std::size_t k = 0; k < constants_.size(); ++k) {
      auto& constant = *std::ranges::find(result.constants, constants_[k].name, &IdentifiedConstant::name);
      constant.value = constants_[k].in(material_);
      constant.half_width = widths[k] * (constants_[k].kind == ConstantKind::modulus ? constant.value : 1.0);
    }
  }

  /// Gives a constant the deck's value for good.
  void hold(std::ptrdiff_t place, Identification& result) {
    const ElasticConstant held = constants_[place];
    auto& constant = *std::ranges::find(result.constants, held.name, &IdentifiedConstant::name);
    constant.determined = false;
    constant.value = constant.start;
    held.in(material_) = constant.start;
    constants_.erase(constants_.begin() + place);
  }

  const IdentificationOptions& options_;
  StrainedBody body_;
  scene::Material start_, material_;
  std::vector<Line> lines_;  ///< to be fitted
  double highest_ = 0.0;     ///< of all lines, Hz
  ElasticConstants constants_;
  std::optional<FrequencyModel> model_;
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd jacobian_;
  int solves_ = 0;
};

std::optional<double> rms_of(const std::vector<AssignedLine>& lines, bool fitted) {
  double sum = 0.0;
  int count = 0;
  for (const AssignedLine& line : lines) {
    if (line.modes > 0 && line.is_fitted == fitted) {
      sum += line.cents * line.cents;
      ++count;
    }
  }
  return count == 0 ? std::nullopt : std::optional(std::sqrt(sum / count));
}

/// Assigns all lines, also those that were not fitted.
void assign(const std::vector<Line>& lines, const MaterialFit& fit, double tolerance, Identification& result) {
  const FrequencyModel& model = fit.model();
  const Eigen::VectorXd frequencies = model.frequencies(fit.material());
  std::vector<bool> seen(model.multiplets().size());
  for (std::size_t l = 0; l < lines.size(); ++l) {
    result.lines.push_back({.line = lines[l], .is_fitted = l < fit.fitted_lines()});
  }
  for (const auto& [l, m] : match_lines(lines, model, fit.material(), tolerance)) {
    AssignedLine& line = result.lines[l];
    line.first_mode = model.multiplets()[m].first + 1;
    line.modes = model.multiplets()[m].count;
    line.computed = frequencies[m];
    line.cents = analysis::cents(line.line.frequency, line.computed);
    seen[m] = true;
  }
  for (std::size_t m = 0; m < seen.size(); ++m) {
    if (!seen[m] && frequencies[m] > lines.front().frequency && frequencies[m] < lines.back().frequency) {
      const Multiplet& multiplet = model.multiplets()[m];
      result.missing.push_back({multiplet.first + 1, multiplet.count, frequencies[m]});
    }
  }
}

void add_damping(Identification& result) {
  std::vector<Decay> decays;
  for (const AssignedLine& line : result.lines) {
    if (line.modes > 0 && line.line.decay_time) {
      decays.push_back({line.line.frequency, *line.line.decay_time});
    }
  }
  if (const auto damping = fit_damping(decays)) {
    result.material.damping = *damping;
    result.has_damping = true;
  }
}

}  // namespace

Identification identify(const scene::Scene& scene, const Measurements& measured, const IdentificationOptions& options) {
  MaterialFit fit(scene, measured, options);
  Identification result;
  fit.run(result);
  assign(measured.lines, fit, options.tolerance, result);
  result.fitted_rms = rms_of(result.lines, true);
  result.tested_rms = rms_of(result.lines, false);
  add_damping(result);
  return result;
}

}  // namespace idiophone::fitting
