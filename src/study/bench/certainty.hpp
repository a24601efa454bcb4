#pragma once
// How certain it is that cuts do not pass a target.

#include <Eigen/Core>
#include <vector>

#include "idiophone/study/bench/cut_plan.hpp"

namespace idiophone::bench {

/// Errors of partials, or of the intervals above the first one, and what may be wrong with them.
class Certainty {
 public:
  Certainty(const Partials& partials, const PlanOptions& options);

  static constexpr double certain = 3.0;  ///< standard deviations

  /// Of partials, or of ratios the intervals above the first one; [partials] or [partials x ...]
  [[nodiscard]] Eigen::MatrixXd of_intervals(const Eigen::MatrixXd& cents) const;

  [[nodiscard]] bool is_in_tune(const Eigen::VectorXd& errors) const;

  /// Whether all partials are known as well as they must be, without another tap.
  [[nodiscard]] bool is_measured() const;

  /// Standard deviations of the errors now. [partials] cents
  [[nodiscard]] const Eigen::VectorXd& measured() const { return measured_; }

  /// Standard deviations of the errors after some cuts. Slopes of different partials are wrong independently.
  [[nodiscard]] Eigen::VectorXd after(const std::vector<Cut>& cuts) const;

  /// What must be left of the errors, so that a spread does not pass a target by more than allowed. All partials that
  /// are out of tune keep the same share, so that what is left of the same cuts does the rest. [partials] cents
  [[nodiscard]] Eigen::VectorXd to_leave(const Eigen::VectorXd& errors, const Eigen::VectorXd& spread) const;

  /// By how much targets may be passed more than allowed, in the direction in which they are passed; zero of cuts that
  /// are safe. [partials] cents
  [[nodiscard]] Eigen::VectorXd too_far(const Eigen::VectorXd& errors, const Eigen::VectorXd& expected,
                                        const Eigen::VectorXd& spread) const;

  /// Whether errors become less together, and none of a partial that is out of tune becomes more.
  [[nodiscard]] bool are_nearer(const Eigen::VectorXd& expected, const Eigen::VectorXd& errors) const;

  /// Whether the error of the depth of a cut matters little beside what a partial may be wrong, or is wrong now.
  /// @param slopes     of its intervals, cents/m
  /// @param roughness  how many times as much as a gentle cut it may matter
  [[nodiscard]] bool is_gentle(const Eigen::VectorXd& slopes, const Eigen::VectorXd& errors, double roughness) const;

 private:
  const PlanOptions& options_;
  bool are_ratios_;
  Eigen::VectorXd measured_;
  Eigen::VectorXd limits_;  ///< [partials] by which a target may be passed, cents
};

}  // namespace idiophone::bench
