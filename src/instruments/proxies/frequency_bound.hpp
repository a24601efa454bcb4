#pragma once
// What limits the steps of a lattice.

#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// Upper bounds of the frequencies of a lattice, one from each mass. [masses]
struct FrequencyBounds {
  std::vector<double> squares;      ///< (rad/s)^2, 0 if it is pinned; the largest is above those of all frequencies
  std::vector<double> weights;      ///< v of frequency_bounds(), 0 if it is pinned
  std::vector<Vector3> directions;  ///< in which the mass is held most stiffly, of length 1
};

/// With any positive weights v of the masses, a spring that pulls with the tensor T stores
///     (u_b - u_a).T (u_b - u_a) <= (1 + v_b/v_a) u_a.T u_a + (1 + v_a/v_b) u_b.T u_b
/// So no square of an angular frequency is above all of lambda/m, with the largest eigenvalue lambda of the sum of (1 +
/// v_b/v_a) T over the springs of the mass m. With equal weights, that is twice the stiffness that holds the mass.
/// @param rounds  in which weights grow where the bound is large, as in Perron's iteration; 0: equal weights
[[nodiscard]] FrequencyBounds frequency_bounds(std::span<const Vector3> nodes, std::span<const Spring> springs,
                                               std::span<const double> masses, const std::vector<bool>& pinned,
                                               int rounds);

/// Rounds after which the bound of all lattices that were tried is within 4 % of the largest frequency.
constexpr int enough_rounds = 20;

}  // namespace idiophone::proxies
