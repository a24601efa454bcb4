#pragma once
// What the model of a workpiece says about taps, before and after its cuts.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "idiophone/study/bench/learning.hpp"
#include "tap_hypotheses.hpp"

namespace idiophone::bench {

/// The order of the unknowns of a workpiece.
struct TapUnknowns {
  static constexpr Eigen::Index shift = 0;      ///< of all modes, cents
  static constexpr Eigen::Index thickness = 1;  ///< by which the body is thinner, m

  std::vector<std::string> constants;  ///< their names
  std::size_t modes = 0;               ///< of the uncut body
  std::size_t cuts = 0;

  [[nodiscard]] Eigen::Index constant(std::size_t c) const { return static_cast<Eigen::Index>(2 + c); }
  [[nodiscard]] Eigen::Index own(std::size_t mode) const { return constant(constants.size() + mode); }  ///< cents
  [[nodiscard]] Eigen::Index depth(std::size_t cut) const { return own(modes + cut); }  ///< above the asked one, m
  [[nodiscard]] Eigen::Index size() const { return depth(cuts); }
};

/// Solves the body with the cuts before each tap, in the order of time.
class TapExpectations {
 public:
  /// @throws what Workpiece::material_slopes_of() throws
  TapExpectations(const Workpiece& piece, const std::vector<Cut>& made, const Beliefs& beliefs);

  [[nodiscard]] const TapUnknowns& unknowns() const { return unknowns_; }
  [[nodiscard]] const Strips& strips() const { return strips_; }  ///< of the body at the last tap

  /// @throws std::runtime_error where the tap is not on the body, and what Workpiece::with() throws
  [[nodiscard]] ExpectedTap of(const Tap& tap);

 private:
  void set_mode(ExpectedTap& expected, std::size_t mode, const Workpiece::Solved& body, const Tap& tap) const;
  void set_spread(ExpectedTap& expected, const Tap& tap);

  const Workpiece& piece_;
  const std::vector<Cut>& made_;
  const Beliefs& beliefs_;
  fitting::MaterialSlopes uncut_;
  TapUnknowns unknowns_;
  Strips strips_;                ///< slopes of the modes of the body at this tap
  Eigen::VectorXd before_;       ///< [modes] cents at the tap before, or of the uncut body
  std::size_t cuts_before_ = 0;  ///< at that tap
  bool is_first_ = true;
};

}  // namespace idiophone::bench
