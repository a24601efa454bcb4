#pragma once
// How far a body is from what a search shall tune it to: frequencies, decay times, levels, and bands without modes.

#include <Eigen/Core>
#include <vector>

#include "idiophone/study/fitting/tuning.hpp"
#include "tracked_modes.hpp"

namespace idiophone::fitting {

class Wishes {
 public:
  /// Both must outlive the object.
  /// @throws std::runtime_error if a wanted frequency is to be avoided
  Wishes(const Target& target, const TuningOptions& options);

  /// Numbers at the start of the modes to follow: those of the target, then others whose decay times are wanted.
  [[nodiscard]] const std::vector<int>& numbers() const { return numbers_; }

  /// All modes up to there matter, Hz; 0 if no band is to be avoided.
  [[nodiscard]] double up_to() const;

  /// How far a body is from each wish: cents of the target's modes, then of decay times, of levels, and of bands. Decay
  /// times and levels count in units in which their tolerance is as large as that of the cents. Of a band, it is the
  /// root of the sum of the squares of how deep modes are in it: the cents to its nearer end, from the tolerance
  /// outside. [wishes]
  /// @throws std::runtime_error if nothing damps a mode whose decay time is wanted
  [[nodiscard]] Eigen::VectorXd measures(const TrackedModes& body) const;

  /// The errors of these measures, or of their derivatives in columns: of ratios, the first mode's are taken from those
  /// of all modes. [wishes x columns]
  [[nodiscard]] Eigen::MatrixXd errors(Eigen::MatrixXd measures) const;

  /// The errors that can be other than 0, those of ratios without the first. [residuals x columns]
  [[nodiscard]] Eigen::MatrixXd residuals(const Eigen::MatrixXd& measures) const;

  /// The decay times of a body, and of one that the search began with.
  /// @param slopes  derivatives of the measures by the variables, in their own units, [wishes x variables]
  [[nodiscard]] std::vector<TunedDecay> decays(const TrackedModes& start, const TrackedModes& body,
                                               const Eigen::MatrixXd& slopes) const;

  /// The levels of a body, and of one that the search began with.
  /// @param slopes  as for decays()
  [[nodiscard]] std::vector<TunedLevel> levels(const ModeShapes& start, const ModeShapes& body,
                                               const Eigen::MatrixXd& slopes) const;

  /// What is in the bands of a body.
  [[nodiscard]] std::vector<AvoidedBand> avoided(const ModeShapes& body) const;

 private:
  [[nodiscard]] double decay_time(const TrackedModes& body, const WantedDecay& wanted) const;
  [[nodiscard]] double level_error(const WantedLevel& wanted, double level) const;
  [[nodiscard]] double cents_per_decibel() const { return options_.tolerance / options_.level_tolerance; }
  [[nodiscard]] double cents_per_percent() const { return options_.tolerance / options_.decay_tolerance; }

  const Target& target_;
  const TuningOptions& options_;
  std::vector<int> numbers_;
};

}  // namespace idiophone::fitting
