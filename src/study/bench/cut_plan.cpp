#include "idiophone/study/bench/cut_plan.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "allowed_depths.hpp"
#include "candidates.hpp"
#include "certainty.hpp"

namespace idiophone::bench {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Which candidates may be chosen.
struct Choice {
  bool has_doubted;  ///< those of doubted tools, too
  double roughness;  ///< as of Certainty::is_gentle()
};

/// Each counts where those before it have no safe cuts.
constexpr std::array<Choice, 4> choices = {{{false, 1.0}, {true, 1.0}, {true, 2.0}, {true, 4.0}}};

/// Cuts of one visit, and the body with them.
struct Trial {
  Visit visit;
  std::vector<Cut> all;  ///< with those of earlier visits
  CutBody body;
  VectorXd moved;   ///< [partials] cents by which the cuts of this visit move them
  MatrixXd slopes;  ///< [partials x candidates] half-way between the bodies before and after them, cents/m
};

/// Cuts of a share of their depths, without those that are shallower than `shallowest`.
std::vector<Cut> shallower(const std::vector<Cut>& cuts, double share, double shallowest) {
  std::vector<Cut> result;
  for (Cut cut : cuts) {
    cut.depth *= share;
    if (cut.depth >= shallowest) {
      result.push_back(std::move(cut));
    }
  }
  return result;
}

class Planner {
 public:
  Planner(const CutModel& model, const std::vector<Tool>& tools, const Partials& partials, const PlanOptions& options,
          const std::vector<Cut>& made)
      : model_(model),
        options_(options),
        certainty_(partials, options),
        body_(model({})),
        candidates_(body_.strips, tools, made) {
    plan_.errors = certainty_.of_intervals(partials.cents);
    plan_.measured = certainty_.measured();
  }

  Plan plan() {
    plan_.unreachable = VectorXd::Zero(plan_.errors.size());
    plan_.is_measured = certainty_.is_measured();
    if (certainty_.is_in_tune(plan_.errors)) {
      plan_.verdict = plan_.is_measured ? Verdict::in_tune : Verdict::not_safe;
      return std::move(plan_);
    }
    plan_.unreachable = unreachable_from(plan_.errors);
    if (!certainty_.is_in_tune(plan_.unreachable)) {
      plan_.verdict = Verdict::out_of_reach;
      return std::move(plan_);
    }
    VectorXd errors = plan_.errors;
    while (std::ssize(plan_.visits) < options_.most_visits && !certainty_.is_in_tune(errors)) {
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
    const MatrixXd moves = certainty_.of_intervals(candidates_.slopes(body_.strips));
    return errors + moves * depths_for(moves, -errors, body_.strips.thickness / 2);
  }

  /// [candidates] m
  [[nodiscard]] VectorXd depths_for(const MatrixXd& moves, const VectorXd& goal, double deepest) const {
    return allowed_depths(moves, goal, deepest,
                          [&](Eigen::Index a, Eigen::Index b) { return candidates_.overlap(a, b); });
  }

  /// [partials x candidates] by which those that may be made move the errors, cents/m; zero for all others
  [[nodiscard]] MatrixXd allowed(const MatrixXd& slopes, const VectorXd& errors, const Choice& choice) const {
    MatrixXd moves = certainty_.of_intervals(slopes);
    for (Eigen::Index c = 0; c < moves.cols(); ++c) {
      const bool does_little = options_.deepest * moves.col(c).cwiseAbs().maxCoeff() < options_.tolerance / 2;
      const bool is_refused = !choice.has_doubted && candidates_.is_doubted(c);
      const bool is_rough = !certainty_.is_gentle(moves.col(c), errors, choice.roughness);
      if (is_refused || is_rough || does_little) {
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
      std::vector<Cut> cuts =
          candidates_.cuts(slopes, depths_for(moves, left - from, options_.deepest), options_.depth_error);
      const VectorXd expected = from + certainty_.of_intervals(sum_of(cuts, errors.size()));
      if (expected.norm() < least && certainty_.are_nearer(expected, errors) &&
          certainty_.too_far(errors, expected, certainty_.after(cuts)).isZero()) {
        least = expected.norm();
        best = std::move(cuts);
      }
    }
    return best;
  }

  /// The next visit; none where no cut is safe, or a later one leaves the model, whose tap will tell.
  std::optional<Visit> visit_within_model(const VectorXd& errors) {
    try {
      for (const Choice& choice : choices) {
        if (std::optional<Visit> visit = next_visit(errors, choice)) {
          return visit;
        }
      }
      return {};
    } catch (const OutsideOfModel& outside) {
      if (plan_.visits.empty()) {
        throw OutsideOfModel(std::string("the next cuts can't be planned: ") + outside.what());
      }
      return {};
    }
  }

  /// The body with some cuts more.
  [[nodiscard]] Trial tried(std::vector<Cut> cuts, const MatrixXd& before, const VectorXd& errors) const {
    Trial trial;
    trial.all = made_;
    trial.all.insert(trial.all.end(), cuts.begin(), cuts.end());
    trial.body = model_(trial.all);
    trial.moved = trial.body.moved - body_.moved;
    trial.slopes = (before + candidates_.slopes(trial.body.strips)) / 2;
    for (Cut& cut : cuts) {
      cut.cents = cut.depth * trial.slopes.col(candidates_.number_of(cut));
    }
    trial.visit.expected = errors + certainty_.of_intervals(trial.moved);
    trial.visit.uncertainties = certainty_.after(cuts);
    trial.visit.cuts = std::move(cuts);
    return trial;
  }

  /// By how much a trial may pass targets more than allowed. [partials] cents
  [[nodiscard]] VectorXd too_far(const Trial& trial, const VectorXd& errors) const {
    return certainty_.too_far(errors, trial.visit.expected, trial.visit.uncertainties);
  }

  [[nodiscard]] bool is_good(const Trial& trial, const VectorXd& errors) const {
    return too_far(trial, errors).isZero() && certainty_.are_nearer(trial.visit.expected, errors);
  }

  Visit adopt(Trial trial) {
    made_ = std::move(trial.all);
    body_ = std::move(trial.body);
    plan_.is_settled = true;
    return std::move(trial.visit);
  }

  /// The cuts of one visit. Where the body that is solved with them does not do what the slopes say, as beside grooves
  /// that its mesh bears badly, they may bring the partials hardly nearer. Then other places are tried.
  std::optional<Visit> next_visit(const VectorXd& errors, const Choice& choice) {
    constexpr int most_attempts = 4;
    constexpr double hardly = 0.9;  // of the errors are left
    const MatrixXd before = candidates_.slopes(body_.strips);
    MatrixXd moves = allowed(before, errors, choice);
    std::optional<Trial> best;
    const auto left = [&] { return best ? best->visit.expected.norm() : errors.norm(); };
    for (int attempt = 0; attempt < most_attempts && left() > hardly * errors.norm(); ++attempt) {
      std::vector<Cut> cuts;
      std::optional<Trial> trial =
          attempt > 0 ? trial_within_model(cuts, moves, before, errors) : safe_trial(cuts, moves, before, errors);
      if (trial && trial->visit.expected.norm() < left()) {
        best = std::move(trial);
      }
      if (cuts.empty()) {
        break;
      }
      moves = candidates_.without(cuts, moves);
    }
    return best ? std::optional(adopt(std::move(*best))) : std::nullopt;
  }

  /// As safe_trial(). None where a trial leaves the model: other places are no must.
  std::optional<Trial> trial_within_model(std::vector<Cut>& cuts, const MatrixXd& moves, const MatrixXd& before,
                                          const VectorXd& errors) {
    try {
      return safe_trial(cuts, moves, before, errors);
    } catch (const OutsideOfModel&) {
      return {};
    }
  }

  /// Cuts that are chosen by slopes, then made deeper or less deep by slopes half-way between the body before and after
  /// them. Where the rounds do not end, the cuts become shallower until they are safe.
  /// @param cuts  those that were tried last, before they became shallower
  std::optional<Trial> safe_trial(std::vector<Cut>& cuts, MatrixXd moves, const MatrixXd& before,
                                  const VectorXd& errors) {
    constexpr int most_rounds = 5;
    MatrixXd slopes = before;
    VectorXd beside = VectorXd::Zero(errors.size());
    VectorXd margin = beside;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<Cut> next = chosen(moves, slopes, beside + margin, errors);
      if (next.empty()) {
        break;
      }
      cuts = std::move(next);
      Trial trial = tried(cuts, before, errors);
      if (round > 0 && is_good(trial, errors)) {
        return trial;
      }
      slopes = trial.slopes;
      moves = candidates_.only(cuts, certainty_.of_intervals(slopes));
      beside = certainty_.of_intervals(trial.moved - sum_of(trial.visit.cuts, errors.size()));
      margin += round > 0 ? too_far(trial, errors) : VectorXd::Zero(errors.size());
    }
    return shallower_trial(cuts, before, errors);
  }

  std::optional<Trial> shallower_trial(std::vector<Cut> cuts, const MatrixXd& before, const VectorXd& errors) {
    plan_.is_settled = plan_.is_settled && cuts.empty();
    constexpr double share = 0.6;
    while (!(cuts = shallower(cuts, share, options_.depth_error)).empty()) {
      Trial trial = tried(cuts, before, errors);
      if (is_good(trial, errors)) {
        return trial;
      }
    }
    return {};
  }

  const CutModel& model_;
  const PlanOptions& options_;
  Certainty certainty_;
  CutBody body_;  ///< with the cuts of the visits so far
  Candidates candidates_;
  std::vector<Cut> made_;  ///< at the visits so far
  Plan plan_;
};

}  // namespace

VectorXd slopes_of(const Strips& strips, const Tool& tool, double place) {
  VectorXd slopes = VectorXd::Zero(strips.slopes.rows());
  for (std::size_t strip = 0; strip < strips.places.size(); ++strip) {
    const double middle = strips.places[strip] - place, half = strips.width / 2;
    const double share = mean_depth_share(tool, middle - half, middle + half);
    slopes += share * strips.slopes.col(static_cast<Eigen::Index>(strip));
  }
  return slopes;
}

Plan plan_cuts(const CutModel& model, const std::vector<Tool>& tools, const Partials& partials,
               const PlanOptions& options, const std::vector<Cut>& made) {
  return Planner(model, tools, partials, options, made).plan();
}

Plan ambiguous_plan(const Partials& partials, const PlanOptions& options) {
  const Certainty certainty(partials, options);
  return {.verdict = Verdict::ambiguous,
          .errors = certainty.of_intervals(partials.cents),
          .measured = certainty.measured(),
          .unreachable = VectorXd::Zero(partials.cents.size())};
}

}  // namespace idiophone::bench
