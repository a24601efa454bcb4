#pragma once
// Smooth functions of space through values at given points.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::measured_maps {

/// The weights of the values at some points in the values at other places, of the spline
/// f(x) = sum_k w_k |x - x_k|^3 + a + b.x, sum_k w_k = 0, sum_k w_k x_k = 0 (Duchon 1977). Through points of a line it
/// is the natural cubic spline. It changes linearly far away. Points that lie almost in a plane or on a line tell
/// nothing of other directions: b has no part in directions in which they reach less than a tenth as far as in the
/// widest one. Values of several blows at one point are averaged.
/// @param points  at least one, m
/// @param places  m
/// @return [places x points]
[[nodiscard]] Eigen::MatrixXd spline_weights(std::span<const Vector3> points, std::span<const Vector3> places);

}  // namespace idiophone::measured_maps
