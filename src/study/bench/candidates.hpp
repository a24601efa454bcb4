#pragma once
// Cuts that may be made.

#include <Eigen/Core>
#include <vector>

#include "idiophone/study/bench/cut_model.hpp"

namespace idiophone::bench {

/// All tools at all places of a body where their cuts lie within it, a quarter of a tool's radius apart. A tool whose
/// cuts are doubted is not led over an earlier groove of such a tool: in a bar 7.4 mm thick, 0.41 mm over a groove of
/// 0.24 mm did 1.9 times what its slope said.
class Candidates {
 public:
  /// @param made  cuts that the body has already
  Candidates(const Strips& strips, const std::vector<Tool>& tools, const std::vector<Cut>& made = {});

  /// [partials x candidates] cents/m
  [[nodiscard]] Eigen::MatrixXd slopes(const Strips& strips) const;

  /// Whether it is a cut by a tool that the model bears less than others (doubt_narrow_tools()).
  [[nodiscard]] bool is_doubted(Eigen::Index candidate) const;

  /// Whether two of them take material from the same place.
  [[nodiscard]] bool overlap(Eigen::Index one, Eigen::Index other) const;

  /// Cuts of some depths, by their places, without those that are shallower than `shallowest`.
  /// @param slopes  [partials x candidates] cents/m
  /// @param depths  [candidates] m
  [[nodiscard]] std::vector<Cut> cuts(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& depths,
                                      double shallowest) const;

  /// The number of a cut that is one of them.
  [[nodiscard]] Eigen::Index number_of(const Cut& cut) const;

  /// The columns of some cuts; zero for all others. [partials x candidates]
  [[nodiscard]] Eigen::MatrixXd only(const std::vector<Cut>& cuts, const Eigen::MatrixXd& moves) const;

  /// Zero for the columns of candidates that overlap some cuts. [partials x candidates]
  [[nodiscard]] Eigen::MatrixXd without(const std::vector<Cut>& cuts, Eigen::MatrixXd moves) const;

 private:
  struct Candidate {
    Tool tool;
    double place = 0.0;  ///< m
  };

  std::vector<Candidate> candidates_;
};

/// The cents by which cuts move partials together. [partials]
[[nodiscard]] Eigen::VectorXd sum_of(const std::vector<Cut>& cuts, Eigen::Index partials);

}  // namespace idiophone::bench
