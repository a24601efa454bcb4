#include "idiophone/solids/motion/stable_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

/// Whether a small kick stays small over many steps.
bool is_stable(Laboratory& lab, double step) {
  lab.begin(step);
  lab.advance(3000);
  bool small = true;
  for (std::size_t node = 0; node < lab.mesh.nodes.size(); ++node) {
    small = small && lab.displacement(node).norm() < 1e-2;  // NaN compares false
  }
  return small;
}

class StableStepTest : public ::testing::TestWithParam<double> {};

ON_RANKS(1);

TEST_P(StableStepTest, StepsJustBelowAreStableAndJustAboveAreNot) {
  for (const auto type : {element::tet4, element::tet10}) {
    Laboratory lab(support::block_mesh(type, {0.2, 0.1, 0.05}, {4, 2, 1}));
    lab.scene.materials[0].damping.stiffness = GetParam();
    lab.fix("x0");
    lab.push("x1", {1e-4, 3e-4, 1e-3}, 1e-3);
    const FiniteElementDynamics dynamics(lab.scene, lab.part, lab.attachments);
    const StableStep limit = find_stable_steps(lab.part, dynamics)[0];
    EXPECT_TRUE(is_stable(lab, 0.99 * limit.step));
    EXPECT_FALSE(is_stable(lab, 1.05 * limit.step));
    EXPECT_GE(limit.element, 0);
    EXPECT_LT(limit.element, lab.mesh.element_count());
  }
}

INSTANTIATE_TEST_SUITE_P(Damping, StableStepTest, ::testing::Values(0.0, 1e-4));

TEST(StableStep, SupportStiffnessAndDashpotsLowerIt) {
  Laboratory lab(support::block_mesh(element::tet4, {0.2, 0.1, 0.05}, {4, 2, 1}));
  const auto limit = [&] {
    return find_stable_steps(lab.part, FiniteElementDynamics(lab.scene, lab.part, lab.attachments))[0];
  };
  const StableStep alone = limit();
  lab.scene.bodies[0].supports.push_back({"foot", {}, 1e6, 0.0});
  lab.attachments.bodies[0].supports.push_back({{0}, {1.0}});
  const StableStep sprung = limit();
  EXPECT_GT(sprung.largest_frequency, 1.2 * alone.largest_frequency);
  lab.scene.bodies[0].supports[0].damping = 100;
  EXPECT_LT(limit().step, sprung.step);
}

TEST(ChooseStepsPerSample, ResolvesTheBandOfLossFactors) {
  scene::Scene scene;
  EXPECT_EQ(choose_steps_per_sample(scene.time, scene.audio, 1.0, 0.0), 1);
  EXPECT_EQ(choose_steps_per_sample(scene.time, scene.audio, 1.0, 20000.0), 3);  // 2 pi 20000/44100 = 2.85
  scene.time.steps_per_sample = 2;
  EXPECT_THROW((void)choose_steps_per_sample(scene.time, scene.audio, 1.0, 20000.0), std::runtime_error);
}

TEST(ChooseStepsPerSample, NamesWhatMakesTooManySteps) {
  const scene::Scene scene;
  const auto refusal = [&](double step, double highest_loss) {
    try {
      static_cast<void>(choose_steps_per_sample(scene.time, scene.audio, step, highest_loss));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(1e-11, 0.0),
            "the motion needs 2.52e+06 steps per audio sample, more than 100000: the largest stable step is 1e-11 s. "
            "Small or flat elements, a stiff or light material, and a large damping.stiffness make it short");
  EXPECT_EQ(refusal(1e-6, 1e9),
            "the motion needs 1.42e+05 steps per audio sample, more than 100000: the loss factor holds up to 1e+09 Hz; "
            "lower the upper end of the materials' damping.band");
}

TEST(ChooseStepsPerSample, IsAMultipleOfTheReadsAndHonoursTheDeck) {
  scene::Scene scene;
  EXPECT_EQ(choose_steps_per_sample(scene.time, scene.audio, 1e-6, 0.0),
            28);  // 1/(44100 0.9e-6) = 25.2; seven reads of four steps
  scene.time.steps_per_sample = 40;
  EXPECT_EQ(choose_steps_per_sample(scene.time, scene.audio, 1e-6, 0.0), 40);
  scene.time.steps_per_sample = 20;
  EXPECT_THROW((void)choose_steps_per_sample(scene.time, scene.audio, 1e-6, 0.0), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::motion
