#include "certainty.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::bench {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Standard deviations of partials, or of the intervals above the first one.
VectorXd deviations_of(const VectorXd& partials, bool are_ratios) {
  VectorXd deviations = partials;
  if (are_ratios) {
    deviations = (partials.array().square() + std::pow(partials[0], 2)).sqrt();
    deviations[0] = 0.0;
  }
  return deviations;
}

/// What a metre of depth does from the bottom of a cut on, over what a metre of the cut does: grooves do more the
/// deeper they are.
/// @param deeper  m, how far below the bottom
double steepness_of(const Cut& cut, double deeper) {
  Cut deep = cut;
  deep.depth += deeper;
  const double here = modelled_depth(cut);
  return (modelled_depth(deep) - here) / deeper * cut.depth / here;
}

}  // namespace

Certainty::Certainty(const Partials& partials, const PlanOptions& options)
    : options_(options),
      are_ratios_(partials.are_ratios),
      measured_(deviations_of(partials.uncertainties, partials.are_ratios)) {
  constexpr double passed = 5.0 / 3;  // of the tolerance
  VectorXd tapped = partials.uncertainties;
  for (std::size_t p = 0; p < partials.carried.size(); ++p) {
    if (partials.carried[p]) {
      tapped[static_cast<Eigen::Index>(p)] = 0.0;
    }
  }
  limits_ = (certain * deviations_of(tapped, are_ratios_)).cwiseMax(passed * options.tolerance);
}

MatrixXd Certainty::of_intervals(const MatrixXd& cents) const {
  return are_ratios_ ? MatrixXd(cents.rowwise() - cents.row(0)) : cents;
}

bool Certainty::is_in_tune(const VectorXd& errors) const {
  return errors.cwiseAbs().maxCoeff() <= options_.tolerance;
}

bool Certainty::is_measured() const {
  return ((certain * measured_).array() <= limits_.array()).all();
}

VectorXd Certainty::after(const std::vector<Cut>& cuts) const {
  ArrayXd squares = measured_.array().square();
  VectorXd moved = VectorXd::Zero(measured_.size());
  for (const Cut& cut : cuts) {
    moved += std::max(options_.slope_error, cut.tool.slope_error) * cut.cents;
    const double deeper = steepness_of(cut, certain * options_.depth_error) * options_.depth_error;
    squares += (deeper / cut.depth * of_intervals(cut.cents).array()).square();
  }
  ArrayXd by_slopes = moved.array().square();
  if (are_ratios_) {
    const double of_first = by_slopes[0];
    by_slopes += of_first;
    by_slopes[0] = 0.0;
  }
  return (squares + by_slopes).sqrt();
}

VectorXd Certainty::to_leave(const VectorXd& errors, const VectorXd& spread) const {
  const ArrayXd ways = errors.array().abs();
  ArrayXd rest = (certain * spread - limits_).array().max(0.0).min(ways);
  const double share = (ways > limits_.array()).select(rest / ways, 0.0).maxCoeff();
  rest = rest.max(share * ways);
  return (errors.array() > 0).select(rest, -rest);
}

VectorXd Certainty::too_far(const VectorXd& errors, const VectorXd& expected, const VectorXd& spread) const {
  constexpr double nothing = 1e-9;  // cents
  const ArrayXd up = (errors.array() > 0).select(ArrayXd::Constant(errors.size(), -1), 1);
  const ArrayXd passed = up * expected.array() + certain * spread.array() - limits_.array();
  return (passed > nothing).select(up * passed, 0.0);
}

bool Certainty::are_nearer(const VectorXd& expected, const VectorXd& errors) const {
  const ArrayXd most = errors.array().abs().max(limits_.array());
  return expected.norm() < errors.norm() && (expected.array().abs() <= most).all();
}

bool Certainty::is_gentle(const VectorXd& slopes, const VectorXd& errors, double roughness) const {
  constexpr double share = 0.25;  // of the error
  const ArrayXd thrown = certain * options_.depth_error * slopes.array().abs();
  return (thrown <= roughness * limits_.array().max(share * errors.array().abs())).all();
}

}  // namespace idiophone::bench
