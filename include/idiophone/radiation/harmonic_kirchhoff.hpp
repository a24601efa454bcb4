#pragma once
// Model kirchhoff for one frequency, to be compared with boundary elements.

#include <span>
#include <vector>

#include "idiophone/radiation/boundary_elements.hpp"

namespace idiophone::radiation {

/// Pressure times distance in the far field (Pa m, [directions], phase as BoundaryElements::far_field) by Kirchhoff's
/// integral with the surface pressure `oscillating` (surface/surface_pressure.hpp). Nothing scatters.
/// @param first, last      the triangles of the body that moves: [first, last)
/// @param normal_velocity  [3 x triangles of the boundary], m/s
[[nodiscard]] std::vector<Complex> kirchhoff_far_field(const Boundary& boundary, Index first, Index last,
                                                       const QuietAir& air, double wave_number,
                                                       std::span<const Complex> normal_velocity,
                                                       std::span<const Vector3> directions);

}  // namespace idiophone::radiation
