#pragma once
// A step of an integrator, as a matrix.

#include <Eigen/Core>

#include "idiophone/instruments/proxies/integrator.hpp"

namespace idiophone::proxies {

/// What a step makes of the displacement and velocity of an oscillator without force.
/// @param angular_frequency  without damping, rad/s
/// @param step               s
[[nodiscard]] Eigen::Matrix2d oscillator_step(Integrator integrator, double angular_frequency, const Damping& damping,
                                              double step);

}  // namespace idiophone::proxies
