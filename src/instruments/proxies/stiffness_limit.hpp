#pragma once
// How stiff fitted springs may be.

#include <Eigen/Core>
#include <vector>

#include "frequency_bound.hpp"
#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// Residuals of a fit, and how they change.
struct Misfit {
  Eigen::VectorXd values;  ///< [residuals]
  Eigen::MatrixXd slopes;  ///< [springs x residuals] by the logarithms of the factors
};

/// The stiffest mass of a lattice bounds its frequencies: by up to a third above the largest one. Fitted springs may
/// have frequencies up to this bound, so that they need up to a third more steps than the springs of the material.
class StiffnessLimit {
 public:
  explicit StiffnessLimit(const Lattice& lattice);

  /// A residual for each mass whose bound is near the limit or above it.
  /// @param stiffness  of the springs, N/m
  [[nodiscard]] Misfit excess(const Eigen::VectorXd& stiffness) const;

  /// The same springs, softer at masses that are above the limit, so that none is. N/m
  [[nodiscard]] Eigen::VectorXd held(Eigen::VectorXd stiffness) const;

 private:
  [[nodiscard]] FrequencyBounds bounds(const Eigen::VectorXd& stiffness) const;

  const Lattice& lattice_;
  double largest_square_ = 0.0;  // (rad/s)^2
};

}  // namespace idiophone::proxies
