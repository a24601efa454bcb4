#pragma once
// Two-sided bounds for the frequencies of an elastic solid (docs/method/bounds.md).

#include <span>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::eigenmodes {

/// Bounds for the frequencies of the exact elastic solid that has the shape of a mesh, without damping.
struct FrequencyBounds {
  /// The lower bounds assume that the solid has no more than so many modes below `separation`, rigid motions aside.
  int modes_below = 0;
  double separation = 0.0;    ///< Hz
  std::vector<double> lower;  ///< [modes] Hz, by Lehmann and Goerisch
  std::vector<double> upper;  ///< [modes] Hz, by Rayleigh and Ritz
};

/// How many modes frequency_bounds() should have for the bounds of `wanted` ones: those above them separate them from
/// the rest.
[[nodiscard]] int modes_for_bounds(int wanted);

/// Bounds for the lowest modes. Runs on one rank.
/// @param solids  of one body
/// @param mesh    of the body
/// @param shapes  [modes][3 x nodes] shapes of the lowest modes, found with the consistent mass
/// @param wanted  number of modes to bound, below that of the shapes
/// @throws std::runtime_error for tetrahedra, hexahedra of the highest order, curved free faces, springs, fracture
///         surfaces, several materials, prestress, and supports at points or lines, or where PETSc can't;
///         deck::DeckError as motion::attach()
[[nodiscard]] FrequencyBounds frequency_bounds(const scene::Solids& solids, const mesh::Mesh& mesh,
                                               std::span<const std::vector<double>> shapes, int wanted);

}  // namespace idiophone::eigenmodes
