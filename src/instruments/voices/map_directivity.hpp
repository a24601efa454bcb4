#pragma once
// What a sound map radiates in one direction.

#include <complex>
#include <vector>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::voices {

/// Weights of a sphere's directions whose weighted sum is the value in one direction: exact for spherical harmonics
/// below the degree `rings` (hyperinterpolation; I. H. Sloan, J. Approx. Theory 83, 1995).
/// @param direction  unit vector
/// @return [directions]
[[nodiscard]] std::vector<double> weights_in_direction(const sound_maps::MapSphere& sphere, const Vector3& direction);

/// MapSphere::pressure in one direction, by these weights: [modes].
[[nodiscard]] std::vector<std::complex<double>> pressure_in_direction(const sound_maps::SoundMap& map,
                                                                      const Vector3& direction);

}  // namespace idiophone::voices
