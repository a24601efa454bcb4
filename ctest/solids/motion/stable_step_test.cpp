#include "idiophone/solids/motion/stable_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "idiophone/foundation/parallel/petsc.hpp"
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

/// Which bodies of 5 million nodes and more keep, for want of memory.
TEST(StableStep, IsFoundWithEightVectors) {
  Laboratory lab(support::block_mesh(element::tet10, {0.2, 0.1, 0.05}, {8, 4, 2}));
  const auto limit = [&] {
    return find_stable_steps(lab.part, FiniteElementDynamics(lab.scene, lab.part, lab.attachments))[0];
  };
  const StableStep expected = limit();
  parallel::petsc(PetscOptionsSetValue(nullptr, "-stable_step_eps_ncv", "8"));
  const StableStep found = limit();
  parallel::petsc(PetscOptionsClearValue(nullptr, "-stable_step_eps_ncv"));
  EXPECT_NEAR(found.largest_frequency / expected.largest_frequency, 1, 1e-3);
  EXPECT_NE(found.largest_frequency, expected.largest_frequency) << "the option was not heard";
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

/// On ranks that share the block: the fifth of its nodes has a support, and one end is held.
class SharedStableStep : public ::testing::TestWithParam<element::Type> {
 protected:
  SharedStableStep() : lab(support::block_mesh(GetParam(), {0.2, 0.1, 0.05}, {4, 3, 2})) {
    lab.scene.materials[0].damping = {5, 1e-5};
    lab.fix("x0");
    lab.scene.bodies[0].supports.push_back({"foot", {}, 1e4, 3.0});
    lab.attachments.bodies[0].supports.push_back({{5}, {1.0}});
    part = mesh::distribute({lab.mesh}, MPI_COMM_WORLD);
  }

  [[nodiscard]] StableStep together() const {
    return find_stable_steps(part, FiniteElementDynamics(lab.scene, part, lab.attachments), MPI_COMM_WORLD)[0];
  }

  Laboratory lab;
  mesh::Part part;
};

ON_RANKS(1, 2, 3);

TEST_P(SharedStableStep, HasTheBitsOfOneRank) {
  const StableStep alone = find_stable_steps(lab.part, FiniteElementDynamics(lab.scene, lab.part, lab.attachments))[0];
  const StableStep shared = together();
  EXPECT_EQ(shared.largest_frequency, alone.largest_frequency);
  EXPECT_EQ(shared.damping, alone.damping);
  EXPECT_EQ(shared.step, alone.step);
  EXPECT_EQ(shared.element, alone.element);
  EXPECT_EQ(shared.centre, alone.centre);
}

TEST_P(SharedStableStep, FailsOnAllRanksTogether) {
  parallel::petsc(PetscOptionsSetValue(nullptr, "-stable_step_eps_max_it", "1"));
  parallel::petsc(PetscOptionsSetValue(nullptr, "-stable_step_eps_tol", "1e-15"));
  EXPECT_THROW(static_cast<void>(together()), std::runtime_error);
  parallel::petsc(PetscOptionsClearValue(nullptr, "-stable_step_eps_max_it"));
  parallel::petsc(PetscOptionsClearValue(nullptr, "-stable_step_eps_tol"));
  EXPECT_GT(together().step, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Elements, SharedStableStep,
                         ::testing::Values(element::tet4, element::tet10, element::hex(3, 2)));

}  // namespace
}  // namespace idiophone::motion
