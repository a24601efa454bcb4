#pragma once
// Limits of a scene, required by later stages.

namespace idiophone::scene {

inline constexpr double farthest_coordinate = 1e4;    ///< magnitude, of bodies, listeners and meshes, m
inline constexpr double most_steps_per_sample = 1e5;  ///< the limit of surface::Sampling

}  // namespace idiophone::scene
