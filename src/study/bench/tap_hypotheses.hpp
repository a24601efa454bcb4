#pragma once
// Which line of a tap is which mode, and what the taps tell about a body.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/study/fitting/measurements.hpp"

namespace idiophone::bench {

/// What a model says about a tap. `unknowns` are zero where the body is as the model has it.
struct ExpectedTap {
  Eigen::VectorXd cents;      ///< [modes] 1200 log2 of the frequencies in Hz
  Eigen::MatrixXd slopes;     ///< [modes x unknowns] cents for each 1 of an unknown
  Eigen::VectorXd spread;     ///< [unknowns] standard deviations that come to each unknown since the tap before
  std::vector<double> heard;  ///< [modes] probabilities that the tap has a line of each
};

/// The last line of a mode.
struct HeardLine {
  std::size_t tap = 0;     ///< its number, from 0 on
  double frequency = 0.0;  ///< Hz
};

/// Where a mode is by all taps.
struct Pitch {
  double cents = 0.0;      ///< 1200 log2 of its frequency in Hz
  double deviation = 0.0;  ///< standard deviation, cents
};

/// A way to take the lines of all taps for modes.
struct TapHypothesis {
  Eigen::VectorXd unknowns;                          ///< expected
  Eigen::MatrixXd covariance;                        ///< of the unknowns
  double likelihood = 0.0;                           ///< its logarithm, but for a constant
  std::vector<std::optional<std::size_t>> lines;     ///< [modes] of the last tap; none of a mode that is not heard
  std::vector<std::optional<HeardLine>> heard = {};  ///< [modes] of all taps; none of a mode that was never heard
  /// [modes] standard deviations by which the line of the last tap is above where its mode was expected; 0 without one
  std::vector<double> surprises = {};

  /// @param expected  what the model says about the last tap
  [[nodiscard]] Pitch pitch_of(std::size_t mode, const ExpectedTap& expected) const;
};

/// The likeliest ways to take the lines of taps for modes, one to one in each tap (multiple hypotheses, Reid 1979).
/// Each has the unknowns that its lines tell (Kalman 1960). A line is as far from its mode as the unknowns and its own
/// uncertainty let it be, at most six standard deviations; a mode is heard or not by its probability, and false lines
/// are one in 1000 cents.
class TapHypotheses {
 public:
  /// @param unknowns  their number; all are known to be zero before the first tap, but for ExpectedTap::spread
  explicit TapHypotheses(Eigen::Index unknowns);

  /// @param lines  ascending
  void hear(std::span<const fitting::Line> lines, const ExpectedTap& expected);

  /// By their likelihoods, the likeliest first; never empty.
  [[nodiscard]] const std::vector<TapHypothesis>& all() const { return hypotheses_; }

 private:
  std::vector<TapHypothesis> hypotheses_;
  std::size_t taps_ = 0;
};

/// How certain it is which lines some modes have.
struct Certainness {
  double probability = 0.0;              ///< of all ways that do not contradict the likeliest one, 0 to 1
  const TapHypothesis* rival = nullptr;  ///< the likeliest way that contradicts it; none where there is none
  std::size_t mode = 0;                  ///< the first of the modes about which the rival contradicts it
};

/// Two ways contradict each other where a mode has different lines, or where its line is that of another mode; not
/// where it is taken for a false one. Lines that are not farther apart than they are uncertain count as one.
/// @param modes  that count
/// @param lines  of the last tap
[[nodiscard]] Certainness certainness_of(const TapHypotheses& hypotheses, std::span<const std::size_t> modes,
                                         std::span<const fitting::Line> lines);

}  // namespace idiophone::bench
