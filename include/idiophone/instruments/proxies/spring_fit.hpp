#pragma once
// Springs with which a lattice has the lowest modes of the body, as far as they can be known from elsewhere.

#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// A mode of the body without damping.
struct KnownMode {
  double angular_frequency = 0.0;  ///< rad/s, above 0
  std::vector<Vector3> shape;      ///< [masses of the lattice] displacements, in any unit
};

struct SpringFit {
  std::vector<EdgeFactors> edges;  ///< [tetrahedra] for OwnValues; all tetrahedra around a spring have the same factor
  std::vector<double> before;      ///< [modes] cents: the lattice's modes, ascending, from the known ones
  std::vector<double> after;       ///< [modes] the same with these factors
};

/// How many modes fit_springs() should have: the springs of coarse lattices can't follow many.
[[nodiscard]] std::size_t modes_to_fit(const Lattice& lattice);

/// Finds factors of the springs with which the lattice yields to the inertial forces of the known modes as the body
/// does. With the shapes x_i of unit modal mass on the lattice, it is to have x_i^T M K^-1 M x_j = delta_ij/w_i^2; then
/// it has these modes. Levenberg's and Marquardt's method changes the logarithms of the factors by as little as
/// possible (docs/method/proxies.md, Fitted springs). Factors stay below 10, and largest_angular_frequency() below
/// sqrt(2 lambda/m) of the lattice's stiffest mass m, with the largest eigenvalue lambda of the sum of k n n^T over its
/// springs.
/// @param lattice  with no spring under tension
/// @param modes    the lowest ones beside the rigid motions, ascending
/// @throws std::invalid_argument for springs under tension, shapes of another size, frequencies that are not above 0 or
///         not ascending, no modes, or shapes that the masses can't tell apart
[[nodiscard]] SpringFit fit_springs(const Lattice& lattice, std::span<const KnownMode> modes);

}  // namespace idiophone::proxies
