// Which constants the lines determine, and how well.

#include <algorithm>
#include <cmath>
#include <limits>

#include "material_fit.hpp"

namespace idiophone::fitting {

/// Chooses the constants that the lines determine. The others get the deck's values, but for those without which the
/// lines do not fit.
void MaterialFit::choose() {
  const auto unknowns = static_cast<Eigen::Index>(chosen_.size());
  const Eigen::VectorXd widths = widths_by_lines(Eigen::MatrixXd::Identity(unknowns, unknowns));
  const Eigen::VectorXd may_change = stages_.back().rowwise().sum();
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    const auto place = static_cast<Eigen::Index>(k);
    chosen_[k] = may_change[place] > 0 && widths[place] <= undetermined;
  }
  while (add_needed(chosen_)) {
  }
  material_ = fit_chosen(chosen_).material;
}

/// Adds the errors of the mesh to the uncertainties of the lines and to the intervals. The modes must be those of the
/// constants: what combined modes lack would count as an error of the mesh.
void MaterialFit::weigh() {
  renew_model(roughly);
  adopt(fit_and_match(problem(), material_, {.ties = single_ties(chosen_), .tolerance = options_.tolerance}));
  const std::vector<double> errors = body_.mesh_errors(*model_);
  heed_watch();
  for (const auto& [line, multiplet] : pairs_) {
    mesh_errors_[line] = errors[multiplet];
    lines_[line].uncertainty = std::hypot(lines_[line].uncertainty, errors[multiplet]);
  }
  material_ = fit_chosen(chosen_).material;
  widths_ = widths_by_lines(value_slopes(constants_, material_));
}

/// What the lines that have a mode say, with the mesh errors that are known.
Evidence MaterialFit::evidence() const {
  Evidence evidence{line_residuals(problem(), pairs_, material_), line_slopes(problem(), pairs_, material_),
                    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(pairs_.size()))};
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const std::size_t line = pairs_[i].first;
    evidence.mesh_errors[static_cast<Eigen::Index>(i)] = mesh_errors_[line] / lines_[line].uncertainty;
  }
  return evidence;
}

/// Of the 95 % intervals of what has these derivatives by the unknowns.
Eigen::VectorXd MaterialFit::widths_by_lines(const Eigen::MatrixXd& slopes) const {
  const Evidence known = over_turns(evidence());
  return half_widths(known, residual_spread(known, expected_), expected_, slopes);
}

/// Adds the constant whose change makes the lines fit best, if it does so beyond chance: an F test at 5 %.
bool MaterialFit::add_needed(std::vector<bool>& chosen) const {
  const double squares = fit_chosen(chosen).squares;
  const auto freedom = static_cast<double>(pairs_.size()) - static_cast<double>(std::ranges::count(chosen, true)) - 1;
  if (freedom < 1) {
    return false;
  }
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (!chosen[k] && stages_.back().row(static_cast<Eigen::Index>(k)).sum() > 0) {
      std::vector<bool> more = chosen;
      more[k] = true;
      if (const double rest = fit_chosen(more).squares; rest < least) {
        least = rest;
        best = k;
      }
    }
  }
  if (!best || squares - least < std::pow(student_t(freedom), 2) * std::max(1.0, least / freedom)) {
    return false;
  }
  chosen[*best] = true;
  return true;
}

/// The fit in which only these constants change, and the others have the deck's values.
MaterialFit::Held MaterialFit::fit_chosen(const std::vector<bool>& chosen) const {
  Eigen::VectorXd values = unknowns(constants_, material_);
  const Eigen::VectorXd of_deck = unknowns(constants_, start_);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (!chosen[k]) {
      values[static_cast<Eigen::Index>(k)] = of_deck[static_cast<Eigen::Index>(k)];
    }
  }
  const TurnedMaterial held = with_unknowns(constants_, material_, values);
  if (!is_stable(held)) {
    return {material_, std::numeric_limits<double>::infinity()};
  }
  const TurnedMaterial found =
      fit_pairs(problem(), pairs_, held, {.ties = single_ties(chosen), .tolerance = options_.tolerance});
  return {found, line_residuals(problem(), pairs_, found).squaredNorm()};
}

}  // namespace idiophone::fitting
