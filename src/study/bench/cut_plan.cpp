#include "idiophone/study/bench/cut_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "allowed_depths.hpp"
#include "certainty.hpp"
#include "nonnegative.hpp"

namespace idiophone::bench {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int strides_of_radius = 4;  // places of a tool lie a quarter of its radius apart

/// A cut that may be made.
struct Candidate {
  Tool tool;
  double place = 0.0;
};

/// Cuts that lie within the body.
std::vector<Candidate> candidates_of(const Strips& strips, const std::vector<Tool>& tools) {
  std::vector<Candidate> candidates;
  for (const Tool& tool : tools) {
    const double stride = tool.radius / strides_of_radius;
    for (double place = strips.low() + tool.radius; place <= strips.high() - tool.radius + 1e-9; place += stride) {
      candidates.push_back({tool, place});
    }
  }
  return candidates;
}

/// [partials x candidates] cents/m
MatrixXd slopes_of(const Strips& strips, const std::vector<Candidate>& candidates) {
  MatrixXd slopes(strips.slopes.rows(), static_cast<Eigen::Index>(candidates.size()));
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    slopes.col(static_cast<Eigen::Index>(c)) = slopes_of(strips, candidates[c].tool, candidates[c].place);
  }
  return slopes;
}

VectorXd sum_of(const std::vector<Cut>& cuts, Eigen::Index partials) {
  VectorXd sum = VectorXd::Zero(partials);
  for (const Cut& cut : cuts) {
    sum += cut.cents;
  }
  return sum;
}

class Planner {
 public:
  Planner(const CutModel& model, const std::vector<Tool>& tools, const Partials& partials, const PlanOptions& options)
      : model_(model), options_(options), certainty_(partials, options), body_(model({})) {
    candidates_ = candidates_of(body_.strips, tools);
    plan_.errors = certainty_.of_intervals(partials.cents);
    plan_.measured = certainty_.measured();
  }

  Plan plan() {
    plan_.unreachable = VectorXd::Zero(plan_.errors.size());
    if (certainty_.is_in_tune(plan_.errors)) {
      return std::move(plan_);
    }
    plan_.unreachable = unreachable_from(plan_.errors);
    if (!certainty_.is_in_tune(plan_.unreachable)) {
      plan_.verdict = Verdict::out_of_reach;
      return std::move(plan_);
    }
    constexpr std::size_t most_visits = 8;
    VectorXd errors = plan_.errors;
    while (plan_.visits.size() < most_visits && !certainty_.is_in_tune(errors)) {
      std::optional<Visit> visit = visit_within_model(errors);
      if (!visit) {
        break;
      }
      errors = visit->expected;
      plan_.visits.push_back(std::move(*visit));
    }
    plan_.verdict = plan_.visits.empty() ? Verdict::not_safe : Verdict::cut;
    return std::move(plan_);
  }

 private:
  [[nodiscard]] VectorXd unreachable_from(const VectorXd& errors) const {
    const MatrixXd moves = certainty_.of_intervals(slopes_of(body_.strips, candidates_));
    return errors + moves * depths_for(moves, -errors, body_.strips.thickness / 2);
  }

  /// [candidates] m
  [[nodiscard]] VectorXd depths_for(const MatrixXd& moves, const VectorXd& goal, double deepest) const {
    const auto overlap = [&](Eigen::Index a, Eigen::Index b) {
      const Candidate& one = candidates_[static_cast<std::size_t>(a)];
      const Candidate& other = candidates_[static_cast<std::size_t>(b)];
      return std::abs(one.place - other.place) < one.tool.radius + other.tool.radius;
    };
    return allowed_depths(moves, goal, deepest, overlap);
  }

  /// Cuts of some depths, without those that are shallower than their error.
  [[nodiscard]] std::vector<Cut> cuts_of(const MatrixXd& slopes, const VectorXd& depths) const {
    std::vector<Cut> cuts;
    for (Eigen::Index c = 0; c < depths.size(); ++c) {
      if (depths[c] > 0 && depths[c] >= options_.depth_error) {
        const Candidate& candidate = candidates_[static_cast<std::size_t>(c)];
        cuts.push_back({candidate.tool, candidate.place, depths[c], depths[c] * slopes.col(c)});
      }
    }
    std::ranges::sort(cuts, {}, &Cut::place);
    return cuts;
  }

  /// [partials x candidates] by which those that may be made move the errors, cents/m; zero for all others
  [[nodiscard]] MatrixXd allowed(const MatrixXd& slopes, const VectorXd& errors) const {
    MatrixXd moves = certainty_.of_intervals(slopes);
    for (Eigen::Index c = 0; c < moves.cols(); ++c) {
      const bool does_little = options_.deepest * moves.col(c).cwiseAbs().maxCoeff() < options_.tolerance / 2;
      if (does_little || !certainty_.is_gentle(moves.col(c), errors)) {
        moves.col(c).setZero();
      }
    }
    return moves;
  }

  /// Cuts that go as far as is safe. What they leave depends on how uncertain they are, and the other way round.
  /// @param moves   [partials x candidates] of those that may be chosen, cents/m
  /// @param slopes  [partials x candidates] cents/m
  /// @param beside  [partials] cents by which cuts move the errors beside what the slopes say
  [[nodiscard]] std::vector<Cut> chosen(const MatrixXd& moves, const MatrixXd& slopes, const VectorXd& beside,
                                        const VectorXd& errors) const {
    constexpr int rounds = 12;
    const VectorXd from = errors + beside;
    VectorXd left = errors;
    std::vector<Cut> best;
    double least = errors.norm();
    for (int round = 0; round < rounds; ++round) {
      left = (left + certainty_.to_leave(errors, certainty_.after(best))) / 2;
      std::vector<Cut> cuts = cuts_of(slopes, depths_for(moves, left - from, options_.deepest));
      const VectorXd expected = from + certainty_.of_intervals(sum_of(cuts, errors.size()));
      if (expected.norm() < least && certainty_.too_far(errors, expected, certainty_.after(cuts)).isZero()) {
        least = expected.norm();
        best = std::move(cuts);
      }
    }
    return best;
  }

  /// The next visit; none where no cut is safe, or a later one leaves the model, whose tap will tell.
  std::optional<Visit> visit_within_model(const VectorXd& errors) {
    try {
      return next_visit(errors);
    } catch (const OutsideOfModel& outside) {
      if (plan_.visits.empty()) {
        throw OutsideOfModel(std::string("the next cuts can't be planned: ") + outside.what());
      }
      return {};
    }
  }

  /// The cuts of one visit: chosen by slopes, then made deeper or less deep by slopes half-way between the body before
  /// and after them.
  std::optional<Visit> next_visit(const VectorXd& errors) {
    constexpr int most_rounds = 5;
    const MatrixXd before = slopes_of(body_.strips, candidates_);
    MatrixXd slopes = before;
    MatrixXd moves = allowed(before, errors);
    VectorXd beside = VectorXd::Zero(errors.size());
    VectorXd margin = beside;
    for (int round = 0; round < most_rounds; ++round) {
      Visit visit;
      visit.cuts = chosen(moves, slopes, beside + margin, errors);
      if (visit.cuts.empty()) {
        return {};
      }
      std::vector<Cut> all = made_;
      all.insert(all.end(), visit.cuts.begin(), visit.cuts.end());
      CutBody body = model_(all);
      const VectorXd moved = body.moved - body_.moved;
      slopes = (before + slopes_of(body.strips, candidates_)) / 2;
      moves = only(visit.cuts, certainty_.of_intervals(slopes));
      for (Cut& cut : visit.cuts) {
        cut.cents = cut.depth * slopes.col(number_of(cut));
      }
      beside = certainty_.of_intervals(moved - sum_of(visit.cuts, errors.size()));
      visit.expected = errors + certainty_.of_intervals(moved);
      visit.uncertainties = certainty_.after(visit.cuts);
      const VectorXd too_far = certainty_.too_far(errors, visit.expected, visit.uncertainties);
      margin += round > 0 ? too_far : VectorXd::Zero(errors.size());
      if (round > 0 && too_far.isZero() && visit.expected.norm() < errors.norm()) {
        made_ = std::move(all);
        body_ = std::move(body);
        return visit;
      }
    }
    return {};
  }

  /// The place of a cut's candidate in the list.
  [[nodiscard]] Eigen::Index number_of(const Cut& cut) const {
    return std::ranges::find_if(candidates_,
                                [&](const Candidate& candidate) {
                                  return candidate.place == cut.place && candidate.tool.name == cut.tool.name &&
                                         candidate.tool.radius == cut.tool.radius;
                                }) -
           candidates_.begin();
  }

  /// Moves of the candidates of some cuts; zero for all others.
  [[nodiscard]] MatrixXd only(const std::vector<Cut>& cuts, const MatrixXd& moves) const {
    MatrixXd kept = MatrixXd::Zero(moves.rows(), moves.cols());
    for (const Cut& cut : cuts) {
      kept.col(number_of(cut)) = moves.col(number_of(cut));
    }
    return kept;
  }

  const CutModel& model_;
  const PlanOptions& options_;
  Certainty certainty_;
  CutBody body_;  ///< with the cuts of the visits so far
  std::vector<Candidate> candidates_;
  std::vector<Cut> made_;  ///< at the visits so far
  Plan plan_;
};

}  // namespace

VectorXd slopes_of(const Strips& strips, const Tool& tool, double place) {
  VectorXd slopes = VectorXd::Zero(strips.slopes.rows());
  for (std::size_t strip = 0; strip < strips.places.size(); ++strip) {
    slopes += depth_share(tool, strips.places[strip] - place) * strips.slopes.col(static_cast<Eigen::Index>(strip));
  }
  return slopes;
}

Plan plan_cuts(const CutModel& model, const std::vector<Tool>& tools, const Partials& partials,
               const PlanOptions& options) {
  return Planner(model, tools, partials, options).plan();
}

}  // namespace idiophone::bench
