#pragma once
// Keeps fitted springs from needing more steps than the springs of the material.

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

/// The bound of the frequencies that the stiffest mass of a lattice gives, from equal weights, is above its largest
/// frequency by up to a third. Fitted springs may use this margin.
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
