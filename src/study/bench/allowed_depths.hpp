#pragma once
// Depths of cuts that are limited.

#include <Eigen/Core>
#include <functional>

namespace idiophone::bench {

/// Whether two candidates, by their numbers, take material from the same place.
using Overlap = std::function<bool(Eigen::Index, Eigen::Index)>;

/// Depths x >= 0 that bring slopes x near to a goal, none deeper than allowed: by least squares, those that would be
/// deeper are as deep as allowed, and candidates that do not overlap with them do the rest. [candidates] m
/// @param slopes   [partials x candidates] cents/m
/// @param goal     [partials] cents
/// @param deepest  m
[[nodiscard]] Eigen::VectorXd allowed_depths(Eigen::MatrixXd slopes, Eigen::VectorXd goal, double deepest,
                                             const Overlap& overlap);

}  // namespace idiophone::bench
