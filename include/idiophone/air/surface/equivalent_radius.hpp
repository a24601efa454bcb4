#pragma once
// How large the surface about a triangle is, as the air feels it at low frequencies.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::surface {

/// Larger surfaces are summed in clusters of triangles, which changes radii by less than 1e-3 of them.
inline constexpr std::size_t most_summed_directly = 50'000;

/// Radius of the sphere that carries along, where it moves to and fro, as much air as the surface does about each
/// triangle: a = (3/sqrt 2) sum over the body's triangles of area max(0, n.n')/(4 pi distance), in the reference shape.
/// A sphere's own radius; constant a disc's mean added mass comes out 0.5 dB high. Edges need no care, and the back of
/// a plate does not count.
/// @param surface  all triangles of a body, three corners each so that the normal of eq. 4 points outwards, m; each has
///                 an area
/// @param which    those that the radii are wanted of; the work for each grows as surface.size(), and as its logarithm
///                 where more than most_summed_directly
/// @return         [which] m; each depends on the surface alone, to the bit
[[nodiscard]] std::vector<double> equivalent_radii(std::span<const std::array<Vector3, 3>> surface,
                                                   std::span<const Index> which);

}  // namespace idiophone::surface
