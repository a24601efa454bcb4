// Where a fit begins: how far all frequencies are wrong at first, and how the axes may be turned.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "halton_point.hpp"
#include "material_fit.hpp"

namespace idiophone::fitting {

namespace {

constexpr double judging = 100.0;         // cents; how well lines fit a start
constexpr double largest_shift = 1000.0;  // cents, by which all frequencies may be wrong at first

/// How far around a material fits begin again, so that modes that cross do not lead into a wrong minimum.
std::vector<double> distances_around(bool may_cross) {
  return may_cross ? std::vector{0.03, 0.1} : std::vector<double>{};
}

}  // namespace

/// From the lowest lines and modes, on a coarser mesh where that is possible, until the modes belong to about the
/// constants that they give. Of several materials to begin with, those that fit best are tried. @return the best first
std::vector<MaterialFit::Start> MaterialFit::begin(const std::vector<TurnedMaterial>& materials) {
  constexpr std::size_t most_tried = 10;
  const std::vector<Line> lowest(lines_.begin(), lines_.begin() + std::min(first_lines, lines_.size()));
  std::optional<StrainedBody> coarser = body_.coarser();
  StrainedBody& body = coarser ? *coarser : body_;
  solve_lowest(body, materials.front(), lowest.size());
  std::vector<Start> starts = find_starts(materials, lowest, body);
  starts.resize(std::min(starts.size(), materials.size() > 1 ? most_tried : 1));
  double least = std::numeric_limits<double>::infinity();
  for (Start& start : starts) {
    try {
      approach(lowest, body, start, least);
    } catch (const std::runtime_error&) {  // all that find_modes() throws, if a fit has led to a hardly stable material
      if (starts.size() == 1) {
        throw;
      }
      start.cost = std::numeric_limits<double>::infinity();
    }
    least = std::min(least, start.cost);
  }
  std::ranges::stable_sort(starts, {}, &Start::cost);
  return starts;
}

void MaterialFit::solve_lowest(StrainedBody& body, const TurnedMaterial& material, std::size_t lines) {
  modelled_ = material;
  model_ = body.lowest(material, static_cast<int>(2 * lines + 5));
  note_solves(1);
}

/// Solves and fits in turn.
/// @param least  what it costs less than is kept
void MaterialFit::approach(const std::vector<Line>& lowest, StrainedBody& body, Start& start, double least) {
  constexpr int most_repetitions = 3;
  const FitRules rules{stages_.back(), std::max(options_.tolerance, first_tolerance / 2), &start.expected};
  const std::vector<double> around = distances_around(has_turns());
  for (int turn = 0; turn < most_repetitions && distance(constants_, start.material, modelled_) > nearby; ++turn) {
    solve_lowest(body, start.material, lowest.size());
    start.material = fit_around({lowest, *model_, constants_}, start.material, rules, around).material;
    start.cost = assign(lowest, *model_, start.material, judging).cost;
    if (start.cost < least) {
      keep(start);
    }
  }
}

/// The search goes on from there, and ends there if it is stopped.
void MaterialFit::keep(const Start& start) {
  material_ = start.material;
  expected_ = start.expected;
}

/// Fits all moduli at once, by the likeliest common shifts of all frequencies, then more and more unknowns, from each
/// of the materials to begin with. @return the best first
std::vector<MaterialFit::Start> MaterialFit::find_starts(const std::vector<TurnedMaterial>& materials,
                                                         const std::vector<Line>& lowest, StrainedBody& body) {
  std::vector<Start> starts;
  double least = std::numeric_limits<double>::infinity();
  const Eigen::VectorXd first_modes = model_->frequencies(modelled_);  // of materials.front(), for the message
  const Multiplet& last = model_->multiplets().back();
  const int first_count = last.first + last.count;
  for (const TurnedMaterial& turned : materials) {
    if (distance(constants_, turned, modelled_) > 0) {
      solve_lowest(body, turned, lowest.size());
    }
    const FitProblem problem{lowest, *model_, constants_};
    const std::vector<double> around = distances_around(turned.turns.isZero(0.0));
    for (const double shift : likely_shifts(lowest, turned)) {
      TurnedMaterial material = with_unknowns(
          constants_, turned, unknowns(constants_, turned) + shift / 600 * std::numbers::ln2 * stages_.front().col(0));
      const Expectation expected = expectation_of(material);
      for (const Ties& ties : stages_) {
        const double tolerance = std::max(options_.tolerance, first_tolerance);
        material = fit_around(problem, material, {ties, tolerance, &expected}, around).material;
      }
      const Assignment matched = assign(lowest, *model_, material, judging);
      if (!matched.pairs.empty()) {
        starts.push_back({material, expected, matched.cost});
      }
      if (!matched.pairs.empty() && matched.cost < least) {
        least = matched.cost;
        keep(starts.back());
      }
    }
  }
  if (starts.empty()) {
    throw std::runtime_error(fmt::format(
        "no line is within {:g} cents of a mode of the body, even if all are shifted by up to {:g} cents. The lines "
        "lie from {:.4g} to {:.4g} Hz, and the lowest {} modes of the body from {:.4g} to {:.4g} Hz, with a density of "
        "{:.4g} kg/m3. Are shape, size, material and constraints those of the measured body? Lengths are in m, the "
        "mass in kg, and lines in Hz",
        judging, largest_shift, lowest.front().frequency, lowest.back().frequency, first_count, first_modes.minCoeff(),
        first_modes.maxCoeff(), materials.front().density));
  }
  std::ranges::stable_sort(starts, {}, &Start::cost);
  return starts;
}

/// How many turns there are to begin with, besides those of the deck.
int MaterialFit::starting_turns() const {
  constexpr int of_one = 12;  // unknown; twice as many for each further one
  const auto turns = std::ranges::count(constants_, ConstantKind::turn, &ElasticConstant::kind);
  return turns == 0 ? 0 : of_one << (turns - 1);
}

/// The deck's axes, and others around them where they may turn. Where the axes lie along planes of symmetry of the
/// body, all derivatives by the turns are zero, so a fit from there alone would stay there.
std::vector<TurnedMaterial> MaterialFit::turned_starts() const {
  constexpr double usual_reach = 0.6;  // rad, of each turn
  const double reach = options_.turn_deviation ? 2 * *options_.turn_deviation : usual_reach;
  std::vector<TurnedMaterial> starts = {start_};
  const auto turns = std::ranges::count(constants_, ConstantKind::turn, &ElasticConstant::kind);
  for (int number = 1; number <= starting_turns(); ++number) {
    const Eigen::ArrayXd places = (halton_point(number, turns).array() - 0.5) / 0.45;  // -1 to 1
    Eigen::VectorXd point = unknowns(constants_, start_);
    point.tail(turns).array() += reach * places;
    starts.push_back(with_unknowns(constants_, start_, point));
  }
  return starts;
}

/// The common shifts of all frequencies to begin with, the likeliest first; none where not all moduli may change.
std::vector<double> MaterialFit::likely_shifts(const std::vector<Line>& lines, const TurnedMaterial& start) const {
  const int most = start.turns.isZero(0.0) ? 3 : 1;
  for (std::size_t k = 0; k < constants_.size(); ++k) {
    if (constants_[k].kind == ConstantKind::modulus && stages_.front().row(static_cast<Eigen::Index>(k)).sum() == 0) {
      return {0.0};
    }
  }
  return common_shifts(lines, *model_, start, largest_shift, most);
}

}  // namespace idiophone::fitting
