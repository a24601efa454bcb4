#pragma once
// The next cuts that bring the partials of a body to their targets (docs/use/bench.md).

#include <Eigen/Core>
#include <vector>

#include "idiophone/study/bench/cut_model.hpp"

namespace idiophone::bench {

/// Partials to tune.
struct Partials {
  Eigen::VectorXd cents;           ///< [partials] above their targets
  Eigen::VectorXd uncertainties;   ///< [partials] standard deviations of `cents`
  bool are_ratios = false;         ///< only intervals above the first partial count, whose pitch is free
  std::vector<bool> carried = {};  ///< [partials] whose lines are of earlier taps; empty: none
};

struct PlanOptions {
  double tolerance = 3.0;     ///< cents, within which a partial is in tune
  double deepest = 1e-3;      ///< m, of one cut
  double depth_error = 1e-4;  ///< m, standard deviation of the depth of a cut
  double slope_error = 0.1;   ///< standard deviation of what a cut does, over that
  int most_visits = 8;        ///< that are planned, from 1 on
};

enum class Verdict {
  in_tune,      ///< no cut is needed
  ambiguous,    ///< a line may be that of another mode
  cut,          ///< make the cuts, and tap again
  not_safe,     ///< any cut may pass a target, or a line that is carried over is too uncertain
  out_of_reach  ///< no removal reaches the targets
};

/// Cuts that are made between two taps.
struct Visit {
  std::vector<Cut> cuts;          ///< by their places
  Eigen::VectorXd expected;       ///< [partials] errors after the cuts
  Eigen::VectorXd uncertainties;  ///< [partials] standard deviations of `expected`
};

/// What to do. Errors are cents above the target; of ratios those of the interval above the first partial.
struct Plan {
  Verdict verdict = Verdict::in_tune;
  Eigen::VectorXd errors = {};       ///< [partials] now
  Eigen::VectorXd measured = {};     ///< [partials] standard deviations of `errors`
  std::vector<Visit> visits = {};    ///< the cuts to make now, and then those of each next visit if each tap gives what
                                     ///< is expected; up to the target, to where no cut is safe, to
                                     ///< the end of the model, or to as many as are planned
  bool is_measured = true;           ///< false where a line that is carried over is too uncertain
  bool is_settled = true;            ///< false where slopes allow cuts, but the solved body refuses them
  Eigen::VectorXd unreachable = {};  ///< [partials] errors that the best cuts, each up to half of the body's thickness,
                                     ///< leave
};

/// What a cut across the side does at a place (m), for each metre of its depth. [partials] cents/m
[[nodiscard]] Eigen::VectorXd slopes_of(const Strips& strips, const Tool& tool, double place);

/// Chooses cuts by non-negative least squares over all tools and places. Each partial goes as near to its target as it
/// can, so that with a probability of 99.9 % (three standard deviations) it does not pass it by more than 5/3 of the
/// tolerance, or than three times the uncertainty of its line where that is more. The uncertainty of a line that is
/// carried over allows nothing, and where it is too large for the limit, the verdict is not `in_tune`. The body is
/// solved with the cuts, and their depths are corrected by the slopes half-way, in up to five rounds; then they become
/// shallower until they are safe. No cut is deeper than allowed.
/// @param model  of the body; what it is with no further cut counts as the measured body
/// @param made   cuts that the body has already, with the slope errors of their tools: grooves of tools that are
/// doubted are
///               not made deeper by such tools
/// It never says `ambiguous`.
/// @throws OutsideOfModel where the model has no answer for the next cuts
[[nodiscard]] Plan plan_cuts(const CutModel& model, const std::vector<Tool>& tools, const Partials& partials,
                             const PlanOptions& options, const std::vector<Cut>& made = {});

/// No cuts, because it is not known which lines the partials have.
[[nodiscard]] Plan ambiguous_plan(const Partials& partials, const PlanOptions& options);

}  // namespace idiophone::bench
