#include "idiophone/study/bench/cut_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "allowed_depths.hpp"
#include "nonnegative.hpp"

namespace idiophone::bench {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double farthest = 100.0;    // cents, by which a cut may move a partial
constexpr int strides_of_radius = 4;  // places of a tool lie a quarter of its radius apart
constexpr double certain = 2.0;       // standard deviations

/// A cut that may be made, for a depth of 1 m.
struct Candidate {
  Tool tool;
  double place = 0.0;
  VectorXd slopes;  ///< [partials] cents/m
};

/// Cuts that lie within the body.
std::vector<Candidate> candidates_of(const Strips& strips, const std::vector<Tool>& tools) {
  std::vector<Candidate> candidates;
  const double low = strips.places.front() - strips.width / 2;
  const double high = strips.places.back() + strips.width / 2;
  for (const Tool& tool : tools) {
    const double stride = tool.radius / strides_of_radius;
    for (double place = low + tool.radius; place <= high - tool.radius + 1e-9; place += stride) {
      candidates.push_back({tool, place, slopes_of(strips, tool, place)});
    }
  }
  return candidates;
}

class Planner {
 public:
  Planner(const std::vector<Candidate>& candidates, double thickness, const Partials& partials,
          const PlanOptions& options)
      : candidates_(candidates),
        thickness_(thickness),
        partials_(partials),
        options_(options),
        errors_(of_intervals(partials.cents)) {
    measured_ = partials.uncertainties;
    if (partials.are_ratios) {
      measured_ = (measured_.array().square() + std::pow(partials.uncertainties[0], 2)).sqrt();
      measured_[0] = 0.0;
    }
    limits_ = (certain * measured_).cwiseMax(options.tolerance);
  }

  Plan plan() {
    Plan result;
    result.errors = result.expected = result.unreachable = errors_;
    result.uncertainties = measured_;
    if (is_in_tune(errors_)) {
      result.unreachable.setZero();
      return result;
    }
    std::vector<Candidate> all = candidates_;
    const MatrixXd slopes = matrix_of(all);
    const VectorXd depths = nonnegative_least_squares(slopes, -errors_).cwiseMin(thickness_ / 2);
    result.unreachable = errors_ + slopes * depths;
    if (!is_in_tune(result.unreachable)) {
      result.verdict = Verdict::out_of_reach;
      return result;
    }
    std::erase_if(all, [&](const Candidate& candidate) { return !is_gentle(candidate); });
    choose(all, result);
    return result;
  }

 private:
  /// Of partials, or of ratios the intervals above the first one.
  [[nodiscard]] VectorXd of_intervals(const VectorXd& cents) const {
    return partials_.are_ratios ? VectorXd(cents.array() - cents[0]) : cents;
  }

  [[nodiscard]] bool is_in_tune(const VectorXd& errors) const {
    return errors.cwiseAbs().maxCoeff() <= options_.tolerance;
  }

  /// [partials x candidates] by which they move the errors, cents/m
  [[nodiscard]] MatrixXd matrix_of(const std::vector<Candidate>& candidates) const {
    MatrixXd matrix(errors_.size(), static_cast<Eigen::Index>(candidates.size()));
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      matrix.col(static_cast<Eigen::Index>(c)) = of_intervals(candidates[c].slopes);
    }
    return matrix;
  }

  /// Whether the error of its depth matters little beside what a partial may be wrong, or is wrong now.
  [[nodiscard]] bool is_gentle(const Candidate& candidate) const {
    const VectorXd thrown = certain * options_.depth_error * of_intervals(candidate.slopes).cwiseAbs();
    return (thrown.array() <= limits_.cwiseMax(errors_.cwiseAbs() / 2).array()).all();
  }

  /// Standard deviations of the errors after some cuts. Slopes of different partials are wrong independently.
  [[nodiscard]] VectorXd uncertainties_after(const std::vector<Cut>& cuts) const {
    Eigen::ArrayXd squares = measured_.array().square();
    VectorXd moved = VectorXd::Zero(errors_.size());
    for (const Cut& cut : cuts) {
      moved += cut.cents;
      squares += (options_.depth_error / cut.depth * of_intervals(cut.cents).array()).square();
    }
    Eigen::ArrayXd by_slopes = (options_.slope_error * moved.array()).square();
    if (partials_.are_ratios) {
      const double of_first = by_slopes[0];
      by_slopes += of_first;
      by_slopes[0] = 0.0;
    }
    return (squares + by_slopes).sqrt();
  }

  [[nodiscard]] VectorXd expected_after(const std::vector<Cut>& cuts) const {
    VectorXd errors = errors_;
    for (const Cut& cut : cuts) {
      errors += of_intervals(cut.cents);
    }
    return errors;
  }

  [[nodiscard]] bool is_safe(const std::vector<Cut>& cuts) const {
    const VectorXd expected = expected_after(cuts);
    const VectorXd uncertainties = uncertainties_after(cuts);
    for (Eigen::Index p = 0; p < expected.size(); ++p) {
      const double passed = errors_[p] > 0 ? -expected[p] : expected[p];
      if (passed + certain * uncertainties[p] > limits_[p]) {
        return false;
      }
    }
    return std::ranges::all_of(cuts, [&](const Cut& cut) {
      return cut.depth <= options_.deepest && cut.cents.cwiseAbs().maxCoeff() <= farthest;
    });
  }

  /// The cuts of a share of the depths, without those that are shallower than their error.
  [[nodiscard]] std::vector<Cut> cuts_of(const std::vector<Candidate>& candidates, const VectorXd& depths) const {
    std::vector<Cut> cuts;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const double depth = depths[static_cast<Eigen::Index>(c)];
      if (depth > 0 && depth >= options_.depth_error) {
        cuts.push_back({candidates[c].tool, candidates[c].place, depth, depth * candidates[c].slopes});
      }
    }
    std::ranges::sort(cuts, {}, &Cut::place);
    return cuts;
  }

  /// Takes the largest safe share of the depths.
  void choose(const std::vector<Candidate>& candidates, Plan& result) const {
    const auto overlap = [&](Eigen::Index a, Eigen::Index b) {
      const Candidate& one = candidates[static_cast<std::size_t>(a)];
      const Candidate& other = candidates[static_cast<std::size_t>(b)];
      return std::abs(one.place - other.place) < one.tool.radius + other.tool.radius;
    };
    const VectorXd depths = allowed_depths(matrix_of(candidates), -errors_, options_.deepest, overlap);
    constexpr int shares = 50;
    result.verdict = Verdict::not_safe;
    for (int share = shares; share > 0; --share) {
      std::vector<Cut> cuts = cuts_of(candidates, depths * share / shares);
      if (!cuts.empty() && is_safe(cuts)) {
        result.verdict = Verdict::cut;
        result.expected = expected_after(cuts);
        result.uncertainties = uncertainties_after(cuts);
        result.cuts = std::move(cuts);
        return;
      }
    }
  }

  const std::vector<Candidate>& candidates_;
  double thickness_;  ///< of the body, m
  const Partials& partials_;
  const PlanOptions& options_;
  VectorXd errors_;    ///< [partials] cents
  VectorXd measured_;  ///< [partials] their standard deviations
  VectorXd limits_;    ///< [partials] by which a target may be passed, cents
};

}  // namespace

VectorXd slopes_of(const Strips& strips, const Tool& tool, double place) {
  VectorXd slopes = VectorXd::Zero(strips.slopes.rows());
  for (std::size_t strip = 0; strip < strips.places.size(); ++strip) {
    slopes += depth_share(tool, strips.places[strip] - place) * strips.slopes.col(static_cast<Eigen::Index>(strip));
  }
  return slopes;
}

Plan plan_cuts(const Strips& strips, const std::vector<Tool>& tools, const Partials& partials,
               const PlanOptions& options) {
  const std::vector<Candidate> candidates = candidates_of(strips, tools);
  return Planner(candidates, strips.thickness, partials, options).plan();
}

}  // namespace idiophone::bench
