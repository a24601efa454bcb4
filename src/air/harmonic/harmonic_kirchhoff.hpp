#pragma once
// Models kirchhoff and rayleigh for one frequency, to be compared with boundary elements.

#include <span>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"

namespace idiophone::harmonic {

/// Pressure times distance in the far field (Pa m, [directions], phase as BoundaryElements::far_field).
struct ModelledFarField {
  std::vector<Complex> kirchhoff;  ///< with the surface pressure `oscillating` (surface/surface_pressure.hpp)
  std::vector<Complex> rayleigh;   ///< of the triangles that face a direction, whatever is in front of them
};

/// Nothing scatters.
/// @param first, last      the triangles of the body that moves: [first, last)
/// @param normal_velocity  [3 x triangles of the boundary], m/s
[[nodiscard]] ModelledFarField modelled_far_field(const Boundary& boundary, Index first, Index last,
                                                  const QuietAir& air, double wave_number,
                                                  std::span<const Complex> normal_velocity,
                                                  std::span<const Vector3> directions);

}  // namespace idiophone::harmonic
