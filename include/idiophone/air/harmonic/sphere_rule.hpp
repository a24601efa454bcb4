#pragma once
// Directions for integrals over the unit sphere.

#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::harmonic {

struct SphereRule {
  std::size_t rings = 0;            ///< polar angles, Gauss' nodes, from the z axis on
  std::size_t azimuths = 0;         ///< in each ring, from the x axis towards the y axis
  std::vector<Vector3> directions;  ///< [rings x azimuths] unit vectors, ring after ring
  std::vector<double> weights;      ///< likewise, sr; the sum is 4 pi
};

/// Twice as many azimuths as rings. Exact for spherical harmonics up to the degree 2 rings - 1.
[[nodiscard]] SphereRule sphere_rule(unsigned rings);

}  // namespace idiophone::harmonic
