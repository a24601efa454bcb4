#pragma once
// What limits the steps of a lattice.

#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// Of each mass m, 2 lambda/m with the largest eigenvalue lambda of the sum of k n n^T over its springs; 0 if it is
/// pinned. The largest of them is above the square of every angular frequency. [masses] (rad/s)^2
[[nodiscard]] std::vector<double> frequency_bounds(std::span<const Vector3> nodes, std::span<const Spring> springs,
                                                   std::span<const double> masses, const std::vector<bool>& pinned);

}  // namespace idiophone::proxies
