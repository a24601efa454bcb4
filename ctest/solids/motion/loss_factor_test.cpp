// A free bar of a material with a loss factor: modes at the ends and in the middle of its band die away alike in their
// periods, at their pitches, and the energy never grows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "idiophone/solids/motion/stable_step.hpp"
#include "idiophone/solids/solid/directional_loss.hpp"
#include "idiophone/solids/solid/relaxation.hpp"
#include "laboratory.hpp"
#include "mesh_modes.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

/// A tone of one mode over some periods.
struct Tone {
  double frequency;    ///< rad/s
  double loss_factor;  ///< 2 decay rate/frequency
};

class LossFactorTest : public ::testing::Test {
 protected:
  static constexpr double loss = 0.005;

  LossFactorTest() : lab(support::block_mesh(element::tet10, {1.0, 0.05, 0.04}, {5, 1, 1})) {
    lab.scene.materials[0] = {"steel", 2e11, 0.3, 7850, {}, {}};
    const FiniteElementDynamics dynamics(lab.scene, lab.part, lab.attachments);
    free = modes(lab, dynamics.model(0).masses());
  }
  /// The band from one mode to another, with a little room.
  void give_loss(Eigen::Index low, Eigen::Index high) {
    const double hertz = 2 * std::numbers::pi;
    lab.scene.materials[0].damping.loss = {
        loss, {0.9 * free.frequencies[low] / hertz, 1.1 * free.frequencies[high] / hertz}, {}, {}};
  }
  /// Three quarters of what is stable.
  [[nodiscard]] double step() const {
    const FiniteElementDynamics dynamics(lab.scene, lab.part, lab.attachments);
    return 0.75 * find_stable_steps(lab.part, dynamics)[0].step;
  }

  /// Velocity of a mode at the middle of the last step.
  [[nodiscard]] double modal_velocity(Eigen::Index mode) const {
    const auto mass = lab.motion->dynamics().model(0).masses();
    double sum = 0.0;
    for (std::size_t c = 0; c < 3 * mass.size(); ++c) {
      sum += mass[c / 3] * free.shapes(static_cast<Eigen::Index>(c), mode) * lab.motion->state()[c / 3].velocity[c % 3];
    }
    return sum;
  }
  /// Amplitude and phase of the velocity of a mode, from those of two steps: displacements are no use, as they creep.
  [[nodiscard]] std::complex<double> advance_to_phasor(Eigen::Index mode, int steps, double step) {
    const double half = free.frequencies[mode] * step / 2;
    lab.advance(steps - 1);
    const double before = modal_velocity(mode);
    lab.advance(1);
    const double now = modal_velocity(mode);
    return {(before + now) / 2 / std::cos(half), (before - now) / 2 / std::sin(half)};
  }

  /// Strikes a mode of the body at rest, and looks at it some periods later and again ten periods later.
  Tone ring(Eigen::Index mode) {
    const double dt = step();
    const double w = free.frequencies[mode];
    lab.begin(dt);
    std::vector<double> rows(6 * lab.mesh.nodes.size());
    for (std::size_t c = 0; c < rows.size() / 2; ++c) {
      rows[6 * (c / 3) + 3 + c % 3] = 1e-7 * w * free.shapes(static_cast<Eigen::Index>(c), mode);
    }
    lab.put(rows);
    const auto steps = static_cast<int>(2 * std::numbers::pi / w / dt);  // of a period, less a part of one
    const std::complex<double> early = advance_to_phasor(mode, 3 * steps, dt);
    double angle = 0.0;
    std::complex<double> last = early;
    for (int period = 0; period < 10; ++period) {
      const std::complex<double> now = advance_to_phasor(mode, steps, dt);
      angle += 2 * std::numbers::pi + std::arg(now / last);  // nearly a whole turn
      last = now;
    }
    const double time = 10 * steps * dt;
    return {angle / time, -2 * std::log(std::abs(last / early)) / angle};
  }

  Laboratory lab;
  Modes free;
};

ON_RANKS(1);

TEST_F(LossFactorTest, IsThatOfModesOverMoreThanADecadeAndLeavesTheirPitches) {
  constexpr Eigen::Index first = 6;  // after the rigid ones
  constexpr Eigen::Index last = 60;
  ASSERT_GT(free.frequencies[last] / free.frequencies[first], 20.0);
  give_loss(first, last);
  const solid::Relaxation relaxation = solid::fit_relaxation(*lab.scene.materials[0].damping.loss);
  for (const Eigen::Index mode : {first, first + 4, first + 8, Eigen::Index{20}, Eigen::Index{35}, last}) {
    const Tone tone = ring(mode);
    const double w = free.frequencies[mode];
    EXPECT_NEAR(tone.loss_factor / loss, 1.0, 0.055) << "mode " << mode;
    const auto modulus = relaxation.modulus(w);
    EXPECT_NEAR(tone.loss_factor / (modulus.imag() / modulus.real()), 1.0, 0.01) << "mode " << mode;
    // Real and discrete: the modulus grows a little with frequency; steps of dt raise a frequency by (w dt)^2/24.
    const double expected = w * std::sqrt(modulus.real()) * (1 + std::pow(w * step(), 2) / 24);
    EXPECT_NEAR(tone.frequency / expected, 1.0, 2e-3) << "mode " << mode;
  }
}

/// x^T K x of a shape with this elasticity.
double stiffness_term(const Laboratory& lab, const solid::Elasticity& elasticity, const Eigen::VectorXd& shape) {
  const FiniteElementDynamics dynamics(lab.scene, lab.part, lab.attachments);
  std::vector<solid::NodeState> state(lab.mesh.nodes.size());
  std::vector<solid::NodeForce> force(state.size());
  for (Eigen::Index c = 0; c < shape.size(); ++c) {
    state[static_cast<std::size_t>(c / 3)].velocity[c % 3] = shape[c];
  }
  dynamics.solid(0).add_linear_stiffness_force(0, elasticity, state, force);
  double sum = 0.0;
  for (Eigen::Index c = 0; c < shape.size(); ++c) {
    sum -= shape[c] * force[static_cast<std::size_t>(c / 3)].component[c % 3];
  }
  return sum;
}

TEST_F(LossFactorTest, ByDirectionIsThatOfTheModuliThatAModeStrains) {
  scene::Material& wood = lab.scene.materials[0];
  wood = {"wood", 11.9e9, 0.0, 450, {}, {}};
  wood.orthotropy = {{11.9e9, 0.93e9, 0.51e9}, {0.372, 0.435, 0.467}, {0.76e9, 0.36e9, 0.73e9}};
  free = modes(lab, FiniteElementDynamics(lab.scene, lab.part, lab.attachments).model(0).masses());
  give_loss(6, 30);
  wood.damping.loss->value = 0.02;
  wood.damping.loss->directions = {{0.004, 0.01, 0.01}, {0.02, 0.015, 0.008}};
  const solid::Relaxation relaxation = solid::fit_relaxation(*wood.damping.loss);
  const solid::OrientedMaterial oriented{wood};
  double least = 1.0;
  double most = 0.0;
  for (const Eigen::Index mode : {6, 7, 8, 12, 20}) {
    const double w = free.frequencies[mode];
    const Eigen::VectorXd shape = free.shapes.col(mode);
    const double part = stiffness_term(lab, solid::relaxing_elasticity(oriented), shape) /
                        stiffness_term(lab, solid::elasticity(wood), shape);
    const auto modulus = relaxation.modulus(w);
    const double expected = part * modulus.imag() / (1 + part * (modulus.real() - 1));
    EXPECT_NEAR(ring(mode).loss_factor / expected, 1.0, 0.015) << "mode " << mode;
    least = std::min(least, expected);
    most = std::max(most, expected);
  }
  EXPECT_GT(most, 2 * least) << "the modes strain different moduli";
}

TEST_F(LossFactorTest, EnergyNeverGrows) {
  give_loss(6, 60);
  lab.scene.materials[0].damping.loss->value = 0.02;
  Eigen::VectorXd shape = Eigen::VectorXd::Zero(free.shapes.rows());
  for (const Eigen::Index mode : {6, 9, 15, 30, 50}) {
    shape += 1e-6 * free.frequencies[6] / free.frequencies[mode] * free.shapes.col(mode);
  }
  lab.begin(0.2 * step(), std::span(shape.data(), static_cast<std::size_t>(shape.size())));
  const auto energy = [&] {
    const BodyMotion now = lab.observe();
    return now.kinetic + now.elastic;
  };
  const double start = energy();
  double before = start;
  for (int look = 0; look < 400; ++look) {
    lab.advance(50);
    const double now = energy();
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_LT(before, 0.5 * start);
}

TEST_F(LossFactorTest, StiffensTheBlowAndShortensTheStep) {
  const double elastic = step() / 0.75;
  give_loss(6, 60);
  lab.scene.materials[0].damping.loss->value = 0.3;
  const StableStep limit = find_stable_steps(lab.part, FiniteElementDynamics(lab.scene, lab.part, lab.attachments))[0];
  EXPECT_EQ(limit.highest_loss, lab.scene.materials[0].damping.loss->band[1]);
  EXPECT_LT(limit.step, 0.8 * elastic);
  const auto largest = [&](double dt) {
    lab.scene.bodies[0].spin = {1, 2, 3};
    lab.begin(dt);
    lab.advance(3000);
    return lab.observe().elastic;
  };
  EXPECT_LT(largest(0.99 * limit.step), 1.0);
  EXPECT_FALSE(largest(1.1 * limit.step) < 1.0);
}

TEST_F(LossFactorTest, GoesOnFromASavedStateToTheBit) {
  give_loss(6, 60);
  lab.push("x1", {0, 3, 1e4}, 1e-4);
  expect_a_saved_state_to_go_on(lab, step(), 100);
}

}  // namespace
}  // namespace idiophone::motion
