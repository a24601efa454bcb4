#include "idiophone/instruments/proxies/integrator.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "oscillator_step.hpp"

namespace idiophone::proxies {

namespace {

constexpr int most_steps = 100000;

/// Whether both eigenvalues are in the unit circle (Jury's criterion).
bool is_stable(const Eigen::Matrix2d& step) {
  const double margin = 1e-13;  // of rounding
  const double determinant = step.determinant();
  return std::abs(determinant) <= 1.0 + margin && std::abs(step.trace()) <= 1.0 + determinant + margin;
}

/// Whether this holds from an angular frequency down to a thousandth of it.
bool is_stable_up_to(Integrator integrator, double angular_frequency, const Damping& damping, double step) {
  constexpr int halvings = 10;
  for (int halving = 0; halving < halvings; ++halving) {
    if (!is_stable(oscillator_step(integrator, std::ldexp(angular_frequency, -halving), damping, step))) {
      return false;
    }
  }
  return true;
}

}  // namespace

Eigen::Matrix2d oscillator_step(Integrator integrator, double angular_frequency, const Damping& damping, double step) {
  const double square = angular_frequency * angular_frequency;
  Eigen::Matrix2d rate;
  rate << 0.0, 1.0, -square, -(damping.mass + damping.stiffness * square);
  const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity();
  if (integrator == Integrator::improved_euler) {
    return identity + step * rate + 0.5 * step * step * rate * rate;
  }
  Eigen::Matrix2d velocity = identity, displacement = identity;
  velocity.row(1) += step * rate.row(1);
  displacement(0, 1) = step;
  return displacement * velocity;
}

int stable_steps(Integrator integrator, double angular_frequency, const Damping& damping, double interval) {
  if (integrator == Integrator::improved_euler && damping.mass == 0.0 && damping.stiffness == 0.0) {
    throw std::invalid_argument("improved_euler needs damping; give some, or choose symplectic_euler");
  }
  const auto is_enough = [&](int steps) {
    return is_stable_up_to(integrator, angular_frequency, damping, interval / steps);
  };
  int enough = 1;
  while (!is_enough(enough)) {
    enough *= 2;
    if (enough > most_steps) {
      throw std::invalid_argument(
          "more than 100 000 steps in an audio sample: the material is too stiff for so fine a mesh, or, with "
          "improved_euler, too little damped");
    }
  }
  int too_few = enough / 2;
  while (enough - too_few > 1) {
    const int middle = (enough + too_few) / 2;
    (is_enough(middle) ? enough : too_few) = middle;
  }
  return enough;
}

}  // namespace idiophone::proxies
