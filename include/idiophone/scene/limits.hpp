#pragma once
// Limits of a scene that later stages rely on.

namespace idiophone::scene {

inline constexpr double farthest_coordinate = 1e4;    ///< of bodies, listeners and meshes, either way, m
inline constexpr double most_steps_per_sample = 1e5;  ///< as many as surface::Sampling takes

}  // namespace idiophone::scene
