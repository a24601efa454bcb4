#pragma once
// What a plan of cuts asks of a body.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <stdexcept>
#include <vector>

#include "idiophone/study/bench/cut_side.hpp"
#include "idiophone/study/bench/tool.hpp"

namespace idiophone::bench {

/// A cut across a side of a body.
struct Cut {
  Tool tool;
  double place = 0.0;     ///< m, of its middle along the body
  double depth = 0.0;     ///< m
  Eigen::VectorXd cents;  ///< [partials] by which it moves them; empty of a cut that was made earlier
};

/// The depth of a cut in a model whose nodes move with it, m. Material beside the edges of a groove is relieved, as if
/// the groove were deeper: by the share depth/radius, fitted to bodies that were meshed with grooves that are wider
/// than the body is thick (docs/use/bench.md, Limits). A hollow has no edges.
[[nodiscard]] double modelled_depth(const Cut& cut);

/// Derivative of modelled_depth() by the depth.
[[nodiscard]] double modelled_depth_slope(const Cut& cut);

/// Depth of some cuts together at a place along the body, m.
[[nodiscard]] double depth_of(const std::vector<Cut>& cuts, double along);

/// Mean of depth_of() between two places along the body (m, ascending), m.
[[nodiscard]] double mean_depth_of(const std::vector<Cut>& cuts, const std::array<double, 2>& ends);

/// A body after some cuts, as a model has it.
struct CutBody {
  Eigen::VectorXd moved;  ///< [partials] cents by which these cuts have moved them
  Strips strips;          ///< slopes of the partials for further cuts
};

/// The model has no answer: the cuts go too deep, or a mode is not recognised any more.
struct OutsideOfModel : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Solves a body with cuts beside those that it has already. It may throw OutsideOfModel.
using CutModel = std::function<CutBody(const std::vector<Cut>&)>;

}  // namespace idiophone::bench
