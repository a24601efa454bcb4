// Modal bodies against finite elements of the same mesh.

#include <gmock/gmock.h>

#include <numbers>

#include "memory_archive.hpp"
#include "moving.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

Moving small_bar(int count = 8) {
  Moving bar(block(element::hex(3, 2), {0.2, 0.02, 0.01}, {4, 1, 1}), count);
  bar.body.scene.materials[0].damping = {.mass = 10.0, .stiffness = 2e-7};
  return bar;
}

ON_RANKS(1);

TEST(ModalBody, HeldBarSoundsLikeItsFiniteElements) {
  Moving bar = small_bar();
  bar.body.fix("x0");
  bar.push("x1", {0, 0.3, 1}, 2e-4);
  bar.prepare();
  EXPECT_FALSE(bar.basis[0].is_free);
  // 0.5 cents are 2 % after ten periods; 0.1 dB are 1 %.
  for (const std::size_t mode : {0U, 1U, 2U}) {
    EXPECT_LT(difference(bar, mode, 10 * 2 * std::numbers::pi / bar.basis[0].frequencies[mode]), 0.01) << mode;
  }
}

TEST(ModalBody, FreeBarSoundsLikeItsFiniteElements) {
  Moving bar = small_bar();
  bar.push("x1", {0, 0.3, 1}, 2e-4);
  bar.prepare();
  EXPECT_TRUE(bar.basis[0].is_free);
  for (const std::size_t mode : {0U, 1U}) {
    EXPECT_LT(difference(bar, mode, 10 * 2 * std::numbers::pi / bar.basis[0].frequencies[mode]), 0.03) << mode;
  }
}

TEST(ModalBody, MovesRigidlyLikeItsFiniteElements) {
  Moving bar = small_bar();
  bar.body.scene.gravity = {0, 0, -9.81};
  bar.body.scene.bodies[0].velocity = {1, 2, 3};
  bar.body.scene.bodies[0].spin = {50, -20, 300};
  bar.prepare();
  const auto elements = bar.begin(2e-7, {});
  const auto modal = bar.begin(2e-6, bar.basis);
  for (int n = 0; n < 20000; ++n) {
    elements->advance();
    if (n % 10 == 0) {
      modal->advance();
    }
  }
  const motion::BodyMotion expected = bar.observe(*elements);
  const motion::BodyMotion found = bar.observe(*modal);
  EXPECT_LT((found.centre - expected.centre).norm(), 1e-9);
  EXPECT_LT((found.velocity - expected.velocity).norm(), 1e-9);
  EXPECT_LT((found.angular_momentum - expected.angular_momentum).norm(), 1e-6 * expected.angular_momentum.norm());
  EXPECT_NEAR(std::abs(found.orientation.dot(expected.orientation)), 1.0, 1e-7);
  EXPECT_NEAR(found.kinetic / expected.kinetic, 1.0, 1e-4);
}

TEST(ModalBody, SpinningStruckBarKeepsItsMomenta) {
  Moving bar = small_bar();
  bar.body.scene.materials[0].damping = {};
  bar.body.scene.bodies[0].velocity = {0.5, 0, 0};
  bar.body.scene.bodies[0].spin = {10, -20, 30};
  bar.push("x1", {0, 3, 10}, 5e-4);
  bar.prepare();
  const auto modal = bar.begin(2e-6, bar.basis);
  // Of the nodes as they move, not of the state that is kept.
  const auto momenta = [&] {
    modal->update_nodes();
    Vector3 linear = Vector3::Zero();
    Vector3 angular = Vector3::Zero();
    const Vector3 centre = bar.observe(*modal).centre;
    for (std::size_t node = 0; node < bar.basis[0].nodes(); ++node) {
      const Vector3 velocity(modal->state()[node].velocity);
      const Vector3 place = bar.part.reference[node] + Vector3(modal->state()[node].displacement);
      linear += bar.basis[0].masses[node] * velocity;
      angular += bar.basis[0].masses[node] * (place - centre).cross(velocity);
    }
    return std::pair(linear, angular);
  };
  for (int n = 0; n < 300; ++n) {
    modal->advance();
  }
  const auto before = momenta();
  const motion::BodyMotion early = bar.observe(*modal);
  EXPECT_GT(early.elastic, 1e-7);
  for (int n = 0; n < 20000; ++n) {
    modal->advance();
  }
  const auto after = momenta();
  const motion::BodyMotion late = bar.observe(*modal);
  EXPECT_LT((after.first - before.first).norm(), 1e-7 * before.first.norm());
  EXPECT_LT((after.second - before.second).norm(), 1e-3 * before.second.norm());  // velocities are half a step old
  EXPECT_LT((late.angular_momentum - early.angular_momentum).norm(), 1e-12 * early.angular_momentum.norm());
  EXPECT_NEAR((late.kinetic + late.elastic) / (early.kinetic + early.elastic), 1.0, 1e-4);
}

TEST(ModalBody, EnergyComesFromThePulse) {
  Moving bar = small_bar();
  bar.body.scene.materials[0].damping = {};
  bar.push("x1", {0, 3, 10}, 5e-4);
  bar.prepare();
  const auto modal = bar.begin(2e-6, bar.basis);
  for (int n = 0; n < 400; ++n) {
    modal->advance();
  }
  const motion::BodyMotion now = bar.observe(*modal);
  EXPECT_NEAR((now.kinetic + now.elastic) / modal->work().value(), 1.0,
              0.01);  // the work is of first order in the step
}

TEST(ModalBody, StaticDeflectionUnderALoadIsThatOfAllModes) {
  // A force that lasts: with few modes and the residual flexibility the mean displacement under it is that with many.
  const auto deflection = [](int count, bool residual = true) {
    Moving bar(block(element::hex(2, 2), {0.05, 0.02, 0.02}, {3, 1, 1}), count);
    bar.body.fix("x0");
    bar.body.scene.materials[0].damping = {.mass = 2e4, .stiffness = 0.0};
    bar.prepare();
    const Index node = bar.body.mesh.groups.at("x1").front();
    scene::ForcePulse pulse;
    pulse.force = {0, 0, 100};
    pulse.signal.shape = scene::Signal::Shape::constant;
    pulse.signal.duration = 1.0;
    bar.body.scene.pulses = {pulse};
    bar.pushed = {{{node}, {1.0}}};
    bar.prepare();
    if (!residual) {
      bar.basis[0].residual.clear();
    }
    const auto modal = bar.begin(5e-7, bar.basis);
    for (int n = 0; n < 6000; ++n) {
      modal->advance();
    }
    modal->update_nodes();
    return modal->state()[node].displacement[2];
  };
  const double all = deflection(160);
  // The flexibility is that along the normal, here of an edge, and the force is not along it.
  EXPECT_NEAR(deflection(6) / all, 1.0, 0.1);
  EXPECT_LT(deflection(6, false) / all, 0.85);
}

TEST(ModalBody, GoesOnFromASavedStateToTheBit) {
  Moving bar = small_bar();
  bar.body.scene.bodies[0].spin = {10, -20, 30};
  bar.push("x1", {0, 3, 10}, 5e-4);
  bar.prepare();
  const auto modal = bar.begin(2e-6, bar.basis, 4);
  const auto other = bar.begin(2e-6, bar.basis, 4);
  const auto advance_to = [](motion::Motion& motion, std::int64_t end) {
    while (motion.step_number() < end) {
      motion.advance();
    }
  };
  for (const std::int64_t saved_at : {80, 320}) {  // the force lasts until step 250
    advance_to(*modal, saved_at);
    support::MemoryArchive archive(MPI_COMM_SELF);
    modal->archive(archive, saved_at);
    archive.restore();
    other->archive(archive, saved_at);
    advance_to(*modal, saved_at + 160);
    advance_to(*other, saved_at + 160);
  }
  const auto saved = [](motion::Motion& motion) {
    support::MemoryArchive state(MPI_COMM_SELF);
    motion.archive(state, motion.step_number());
    return state.blocks;
  };
  EXPECT_EQ(saved(*modal), saved(*other));
}

TEST(ModalBody, LongStepsAfterTheLastForceChangeNothing) {
  Moving bar = small_bar();
  bar.body.scene.bodies[0].spin = {10, -20, 30};
  bar.body.scene.gravity = {0, 0, -9.81};
  bar.push("x1", {0, 3, 10}, 2e-4);
  bar.prepare();
  constexpr double step = 1e-6;
  const auto often = bar.begin(step, bar.basis);
  const auto seldom = bar.begin(step, bar.basis, 4);
  int calls = 0;
  for (int n = 0; n < 4000; ++n) {
    often->advance();
  }
  for (; seldom->step_number() < 4000; ++calls) {
    seldom->advance();
  }
  EXPECT_LT(calls, 1300);  // 200 with the force, and the others four at once
  for (const std::size_t mode : {0U, 1U, 2U}) {
    const double expected = bar.coordinate(*often, mode);
    EXPECT_NEAR(bar.coordinate(*seldom, mode), expected, 1e-6 * std::abs(expected)) << mode;
  }
  const motion::BodyMotion exact = bar.observe(*often);
  const motion::BodyMotion found = bar.observe(*seldom);
  EXPECT_LT((found.centre - exact.centre).norm(), 1e-12);
  EXPECT_LT((found.angular_momentum - exact.angular_momentum).norm(), 1e-10 * exact.angular_momentum.norm());
  EXPECT_NEAR(found.elastic / exact.elastic, 1.0, 1e-4);
  EXPECT_NEAR(found.kinetic / exact.kinetic, 1.0, 1e-6);
}

TEST(ModalBody, RefusesABodyThatIsHeldInPart) {
  Moving bar = small_bar();
  bar.body.fix("x0", {true, true, false});
  try {
    bar.prepare();
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("deck.yaml:3:5: body 'block' can still move rigidly in"));
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
