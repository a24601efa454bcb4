#pragma once
// Eigenvalues on the refined mesh, beginning with the modes of the given one.

#include <span>
#include <vector>

#include "idiophone/foundation/part_watch.hpp"
#include "refined_problem.hpp"

namespace idiophone::eigenmodes {

/// Of one mode, (rad/s)^2.
struct RefinedValue {
  double interpolated = 0.0;  ///< of the motion on the given mesh, with the matrices of the refined one
  double improved = 0.0;      ///< of the motion on the refined mesh that it turns into
};

/// Improves modes in blocks by the locally optimal preconditioned gradient method (Knyazev 2001), until a step lowers
/// no eigenvalue by more than a few per cent of what was gained before.
/// @param shapes  [modes][3 x nodes] on the given mesh, ascending by frequency
/// @param chosen  numbers of the modes to improve, ascending. The others below the last of them stay as they are, so
///                that no chosen one turns into them
/// @param watch   after each block, in chosen modes; if it ends the work, there are fewer values
[[nodiscard]] std::vector<RefinedValue> refined_values(const RefinedProblem& problem,
                                                       std::span<const std::vector<double>> shapes,
                                                       std::span<const std::size_t> chosen, const PartWatch& watch);

}  // namespace idiophone::eigenmodes
