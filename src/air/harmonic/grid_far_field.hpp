#pragma once
// The sound of a vibration by radiation model waves, to be compared with boundary elements.

#include <span>
#include <vector>

#include "idiophone/air/harmonic/body_vibrations.hpp"

namespace idiophone::harmonic {

/// Pressure times distance in the far field (Pa m, [directions]), phase as harmonic::BoundaryElements::far_field.
/// There must be no floor. On this rank alone.
/// @param cell  edge of a cell, m
[[nodiscard]] std::vector<harmonic::Complex> grid_far_field(const AcousticSurface& surface, const Vibration& vibration,
                                                            const harmonic::QuietAir& air, double cell,
                                                            std::span<const Vector3> directions);

}  // namespace idiophone::harmonic
