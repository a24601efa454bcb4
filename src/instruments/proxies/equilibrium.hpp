#pragma once
// Where a body is at rest whose springs have other natural lengths than those in its mesh.

#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// Places of the masses where the forces of all springs, k (length - natural), add up to zero on each mass that is not
/// pinned: a minimum of the elastic energy, from the given places by Newton's method with a search along the line.
/// @param nodes    [masses] m
/// @param pinned   [masses] these stay where they are
/// @throws std::invalid_argument when no stable equilibrium is found
[[nodiscard]] std::vector<Vector3> equilibrium(const std::vector<Vector3>& nodes, std::span<const Spring> springs,
                                               const std::vector<bool>& pinned);

}  // namespace idiophone::proxies
