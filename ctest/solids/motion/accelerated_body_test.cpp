// Finite elements on an accelerator move as those of the processor do. Any OpenCL device will do; pocl-opencl-icd is
// one without hardware.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "idiophone/solids/motion/stable_step.hpp"
#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

/// Over the largest displacement: rounding after some hundred steps.
constexpr double rounding = 1e-9;

class AcceleratedBodyTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      accelerator = std::make_unique<accelerator::Accelerator>("0");
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// A bent block that is held at one end and pushed at the other.
  static Laboratory block(element::Type type) {
    mesh::Mesh mesh = support::block_mesh(type, {0.3, 0.06, 0.04}, {3, 2, 1});
    for (Vector3& x : mesh.nodes) {
      x[2] += 2.0 * x[0] * x[0];
    }
    Laboratory lab(std::move(mesh));
    lab.scene.gravity = {0.5, -1.0, -9.81};
    lab.scene.materials[0].damping = {.mass = 3.0, .stiffness = 2e-5};
    return lab;
  }
  static void hold_and_push(Laboratory& lab) {
    lab.fix("x0");
    lab.push("x1", {1.0, 2.0, 5.0}, 0.004);
  }

  static double step(const Laboratory& lab) {
    const FiniteElementDynamics dynamics(lab.scene, lab.part, lab.attachments);
    return 0.7 * find_stable_steps(lab.part, dynamics)[0].step;
  }

  /// The largest difference of displacements over the largest one.
  static double difference(const Laboratory& lab, const Laboratory& reference) {
    double largest = 0.0, wrong = 0.0;
    for (std::size_t node = 0; node < reference.part.node_ids.size(); ++node) {
      largest = std::max(largest, reference.displacement(node).norm());
      wrong = std::max(wrong, (lab.displacement(node) - reference.displacement(node)).norm());
    }
    return wrong / largest;
  }

  /// Both do so many steps. They are then as far from each other as rounding explains, and measured alike.
  void expect_the_same_motion(Laboratory& there, Laboratory& here, int steps = 300) {
    there.accelerator = accelerator.get();
    const double length = step(here);
    for (Laboratory* lab : {&there, &here}) {
      lab->begin(length);
      lab->advance(steps);
    }
    const BodyMotion expected = here.observe(), measured = there.observe();
    EXPECT_LT(difference(there, here), rounding);
    RecordProperty("difference_in_1e_12", std::to_string(1e12 * difference(there, here)));
    EXPECT_NEAR(measured.elastic, expected.elastic, 1e-8 * std::abs(expected.elastic));
    EXPECT_NEAR(measured.kinetic, expected.kinetic, 1e-8 * expected.kinetic);
    EXPECT_NEAR(there.motion->work().value(), here.motion->work().value(),
                1e-8 * std::abs(here.motion->work().value()));
  }

  std::unique_ptr<accelerator::Accelerator> accelerator;
};

ON_RANKS(1);

TEST_F(AcceleratedBodyTest, MovesAsOnTheProcessorWhateverItsElements) {
  for (const element::Type type : {element::tet4, element::tet10, element::hex(2, 2), element::hex(4, 2)}) {
    SCOPED_TRACE(element::name(type));
    Laboratory there = block(type), here = block(type);
    hold_and_push(there);
    hold_and_push(here);
    expect_the_same_motion(there, here);
  }
}

TEST_F(AcceleratedBodyTest, IsAPlateThatMovesAlikeForAThousandSteps) {
  const auto plate = [] {
    Laboratory lab(support::block_mesh(element::hex(4, 2), {0.3, 0.3, 0.01}, {4, 4, 1}));
    lab.fix("x0");
    lab.push("x1", {0.0, 0.0, 0.01}, 0.004);  // N: it moves by a part of its thickness
    return lab;
  };
  Laboratory there = plate(), here = plate();
  expect_the_same_motion(there, here, 1000);
}

TEST_F(AcceleratedBodyTest, RemembersItsStrain) {
  Laboratory there = block(element::hex(2, 2)), here = block(element::hex(2, 2));
  for (Laboratory* lab : {&there, &here}) {
    hold_and_push(*lab);
    lab->scene.materials[0].damping = {.loss = {{0.02, {100.0, 5000.0}, {}, {}}}};
  }
  expect_the_same_motion(there, here);
}

TEST_F(AcceleratedBodyTest, HasRegionsOfWoodAndRubberUnderTension) {
  Laboratory there = block(element::tet10), here = block(element::tet10);
  for (Laboratory* lab : {&there, &here}) {
    hold_and_push(*lab);
    scene::Material wood{"wood", 12e6, 0.0, 450, {.loss = {{0.01, {100.0, 5000.0}, {}, {}}}}, {}};
    wood.orthotropy = {{12e6, 1e6, 0.5e6}, {0.37, 0.43, 0.47}, {0.8e6, 0.04e6, 0.7e6}};
    lab->scene.materials.push_back(wood);
    lab->part.bodies[0].regions.assign(lab->part.bodies[0].element_ids.size(), 0);
    std::fill_n(lab->part.bodies[0].regions.rbegin(), 12, 1);
    lab->scene.bodies[0].regions = {{.name = "rubber", .material = 0, .where = {}},
                                    {.name = "wood", .material = 1, .where = {}}};
    lab->scene.bodies[0].prestress.emplace().stress = Vector3(2e4, 0.0, 0.0).asDiagonal();
  }
  expect_the_same_motion(there, here);
}

TEST_F(AcceleratedBodyTest, FollowsADrivenGroup) {
  Laboratory there = block(element::hex(2, 2)), here = block(element::hex(2, 2));
  for (Laboratory* lab : {&there, &here}) {
    lab->fix("x0");
    scene::DrivenGroup driven;
    driven.group = "x1";
    driven.rotation = {0.0, 0.03, 0.0};
    driven.displacement = {0.0, 1e-3, 0.0};
    driven.signal = {scene::Signal::Shape::sine, 0.0, std::numeric_limits<double>::infinity(), 100.0, {}};
    lab->scene.bodies[0].driven.push_back(driven);
    lab->attachments.bodies[0].driven.push_back({lab->mesh.groups.at("x1"), {}});
  }
  expect_the_same_motion(there, here);
}

TEST_F(AcceleratedBodyTest, GoesOnWhereTheProcessorStoppedAndTheReverse) {
  Laboratory here = block(element::hex(2, 2));
  hold_and_push(here);
  here.scene.materials[0].damping.loss = {0.02, {100.0, 5000.0}, {}, {}};
  here.scene.materials[0].damping.stiffness = 0.0;
  const double length = step(here);
  for (accelerator::Accelerator* first : {accelerator.get(), static_cast<accelerator::Accelerator*>(nullptr)}) {
    here.accelerator = first;
    here.begin(length);
    here.advance(96);
    Motion other(here.scene, here.part, here.attachments, here.contact_surfaces, length, 16, MPI_COMM_SELF,
                 finite_elements_only, 1, first == nullptr ? accelerator.get() : nullptr);
    here.go_on(other, here.motion->step_number());
    here.advance(96);
    other.advance_to(192);
    other.update_nodes();
    here.motion->update_nodes();
    for (std::size_t node = 0; node < here.part.node_ids.size(); ++node) {
      const Eigen::Map<const Vector3> moved(other.state()[node].displacement);
      EXPECT_LT((moved - here.displacement(node)).norm(), rounding * here.displacement(node).norm() + 1e-15);
    }
  }
}

TEST_F(AcceleratedBodyTest, HasTheSameBitsInEachRun) {
  Laboratory lab = block(element::tet10);
  hold_and_push(lab);
  lab.accelerator = accelerator.get();
  expect_a_saved_state_to_go_on(lab, step(lab), 48);
}

TEST_F(AcceleratedBodyTest, RefusesAddedMass) {
  Laboratory lab = block(element::hex(2, 2));
  lab.scene.bodies[0].name = "plate";
  lab.scene.bodies[0].mass_scaling.emplace();
  lab.accelerator = accelerator.get();
  EXPECT_THAT([&] { lab.begin(1e-6); },
              testing::ThrowsMessage<std::runtime_error>(
                  testing::AllOf(testing::HasSubstr("body plate"), testing::HasSubstr("--accelerate waves"))));
}

}  // namespace
}  // namespace idiophone::motion
