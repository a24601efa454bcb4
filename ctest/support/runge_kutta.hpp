#pragma once
// A reference for steps of coupled oscillators.

#include <Eigen/Core>

namespace idiophone::support {

/// Runge and Kutta's method of fourth order.
/// @param acceleration  acceleration(q), without damping
/// @param h             the step
/// @param q, v          places and velocities, which go on
template <class Acceleration>
void runge_kutta_step(const Acceleration& acceleration, double h, Eigen::VectorXd& q, Eigen::VectorXd& v) {
  const Eigen::VectorXd a1 = acceleration(q), v2 = v + h / 2 * a1;
  const Eigen::VectorXd a2 = acceleration(q + h / 2 * v), v3 = v + h / 2 * a2;
  const Eigen::VectorXd a3 = acceleration(q + h / 2 * v2), v4 = v + h * a3;
  const Eigen::VectorXd a4 = acceleration(q + h * v3);
  q += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

}  // namespace idiophone::support
