#pragma once
// Smooth functions of space through values at given points.

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::dense {

/// The spline f(x) = sum_k w_k |x - x_k|^3 + a + b.x, sum_k w_k = 0, sum_k w_k x_k = 0 (Duchon 1977). Through points of
/// a line it is the natural cubic spline. It changes linearly far away. Points that lie almost in a plane or on a line
/// tell nothing of other directions: b has no part in directions in which they reach less than a tenth as far as in the
/// widest one. Several values at one point are averaged.
class SpaceSpline {
 public:
  /// @param points  at least one, m
  /// @param values  [points]
  SpaceSpline(std::span<const Vector3> points, std::span<const double> values);

  /// @param place  m
  [[nodiscard]] double operator()(const Vector3& place) const;

  class Functions;

 private:
  std::shared_ptr<const Functions> functions_;
  Eigen::VectorXd coefficients_;
};

/// The weights that the values at some points have in those of a SpaceSpline at other places.
/// @param points  at least one, m
/// @param places  m
/// @return [places x points]
[[nodiscard]] Eigen::MatrixXd spline_weights(std::span<const Vector3> points, std::span<const Vector3> places);

}  // namespace idiophone::dense
