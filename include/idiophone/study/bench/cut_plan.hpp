#pragma once
// The next cuts that bring the partials of a body to their targets (docs/use/bench.md).

#include <Eigen/Core>
#include <vector>

#include "idiophone/study/bench/cut_side.hpp"
#include "idiophone/study/bench/tool.hpp"

namespace idiophone::bench {

/// Partials to tune.
struct Partials {
  Eigen::VectorXd cents;          ///< [partials] above their targets
  Eigen::VectorXd uncertainties;  ///< [partials] standard deviations of `cents`
  bool are_ratios = false;        ///< only intervals above the first partial count, whose pitch is free
};

struct PlanOptions {
  double tolerance = 3.0;     ///< cents, within which a partial is in tune
  double deepest = 1e-3;      ///< m, of one cut
  double depth_error = 1e-4;  ///< m, standard deviation of the depth of a cut
  double slope_error = 0.1;   ///< standard deviation of what a cut does, over that
};

struct Cut {
  Tool tool;
  double place = 0.0;     ///< m, of its middle along the body
  double depth = 0.0;     ///< m
  Eigen::VectorXd cents;  ///< [partials] by which it moves them
};

enum class Verdict {
  in_tune,      ///< no cut is needed
  cut,          ///< make the cuts, and tap again
  not_safe,     ///< any cut may pass a target
  out_of_reach  ///< no removal reaches the targets
};

/// What to do next. Errors are cents above the target; of ratios those of the interval above the first partial.
struct Plan {
  Verdict verdict = Verdict::in_tune;
  std::vector<Cut> cuts = {};          ///< to make now, by their places
  Eigen::VectorXd errors = {};         ///< [partials] now
  Eigen::VectorXd expected = {};       ///< [partials] errors after the cuts
  Eigen::VectorXd uncertainties = {};  ///< [partials] standard deviations of `expected`
  Eigen::VectorXd unreachable =
      {};  ///< [partials] errors that the best cuts, each up to half of the body's thickness, leave
};

/// What a cut across the side does at a place (m), for each metre of its depth. [partials] cents/m
[[nodiscard]] Eigen::VectorXd slopes_of(const Strips& strips, const Tool& tool, double place);

/// Chooses cuts by non-negative least squares over all tools and places. They go as far as they can, so that with a
/// probability of 97.7 % for each partial (two standard deviations) none passes its target by more than the tolerance,
/// or than twice the uncertainty of its measurement where that is more. No cut is deeper than allowed, and none moves a
/// partial by more than 100 cents, because the slopes hold for small cuts.
/// @param strips  with the slopes of the partials
[[nodiscard]] Plan plan_cuts(const Strips& strips, const std::vector<Tool>& tools, const Partials& partials,
                             const PlanOptions& options);

}  // namespace idiophone::bench
