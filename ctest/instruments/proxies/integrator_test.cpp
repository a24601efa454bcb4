#include "idiophone/instruments/proxies/integrator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "oscillator_step.hpp"

namespace idiophone::proxies {
namespace {

constexpr double fastest = 2e5;  // rad/s
constexpr double interval = 1.0 / 44100;

/// The largest absolute value of the eigenvalues of a step.
double growth(Integrator integrator, const Damping& damping, int steps) {
  const Eigen::Matrix2d step = oscillator_step(integrator, fastest, damping, interval / steps);
  const double mean = 0.5 * step.trace(), determinant = step(0, 0) * step(1, 1) - step(0, 1) * step(1, 0);
  const std::complex<double> root = std::sqrt(std::complex<double>(mean * mean - determinant));
  return std::max(std::abs(mean + root), std::abs(mean - root));
}

TEST(Integrator, StepsAreTheFewestThatAreStable) {
  for (const Integrator integrator : {Integrator::symplectic_euler, Integrator::improved_euler}) {
    for (const double stiffness : {1e-8, 1e-7, 1e-6, 1e-5}) {
      const Damping damping{.mass = 1.0, .stiffness = stiffness};
      const int steps = stable_steps(integrator, fastest, damping, interval);
      EXPECT_LE(growth(integrator, damping, steps), 1.0 + 1e-12);
      EXPECT_GT(growth(integrator, damping, steps - 1), 1.0);
    }
  }
}

TEST(Integrator, SymplecticEulerNeedsTwoRadiansWithoutDamping) {
  const int steps = stable_steps(Integrator::symplectic_euler, fastest, {}, interval);
  EXPECT_EQ(steps, static_cast<int>(std::ceil(fastest * interval / 2.0)));
}

TEST(Integrator, ImprovedEulerNeedsDamping) {
  EXPECT_THROW((void)stable_steps(Integrator::improved_euler, fastest, {}, interval), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::proxies
