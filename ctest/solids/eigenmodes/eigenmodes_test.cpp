// What modes must be whatever the body: orthonormal, damped as their material and supports say, the same on any ranks.

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

using ::testing::HasSubstr;

/// A small bar without symmetries: no two modes alike.
VibratingBody vibrating_bar() {
  return block(element::tet10, {0.2, 0.03, 0.02}, {5, 1, 1});
}

double total(double here) {
  MPI_Allreduce(MPI_IN_PLACE, &here, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return here;
}

int rigid_motions(VibratingBody body) {
  return body.find({.count = 1}).rigid_motions;
}

ON_RANKS(1, 3);

TEST(RigidMotions, AreCounted) {
  EXPECT_EQ(rigid_motions(vibrating_bar()), 6);
  VibratingBody clamped = vibrating_bar();
  clamped.fix("x0");
  EXPECT_EQ(rigid_motions(clamped), 0);
  VibratingBody sliding = vibrating_bar();
  sliding.fix("x0", {true, false, false});
  EXPECT_EQ(rigid_motions(sliding), 3) << "along y and z, and about x";
  VibratingBody pinned = vibrating_bar();
  pinned.mesh.groups["pin"] = {0};
  pinned.fix("pin");
  EXPECT_EQ(rigid_motions(pinned), 3);
  VibratingBody driven = vibrating_bar();
  scene::DrivenGroup drive;
  drive.group = "x0";
  drive.displacement = {0, 0, 1e-3};
  driven.scene.bodies[0].driven.push_back(drive);
  EXPECT_EQ(rigid_motions(driven), 0);
}

TEST(RigidMotions, OneAboutAHinge) {
  VibratingBody hinged = vibrating_bar();
  for (Index node = 0; node < static_cast<Index>(hinged.mesh.nodes.size()); ++node) {
    const Vector3& x = hinged.mesh.nodes[node];
    if (x[0] == 0 && x[2] == 0) {
      hinged.mesh.groups["axle"].push_back(node);
    }
  }
  hinged.fix("axle");
  hinged.scene.bodies[0].fixed[0].hinge = true;
  EXPECT_EQ(rigid_motions(hinged), 1);
}

TEST(RigidMotions, SupportsLeaveModesInTheirPlace) {
  VibratingBody held = vibrating_bar();
  held.scene.bodies[0].supports.push_back({"pad", {.at = {0.1, 0.015, 0}, .radius = 0.05, .where = {}}, 1e5, 0});
  const Modes found = held.find({.count = 7});
  EXPECT_EQ(found.rigid_motions, 0);
  const double mass = 7850 * 0.2 * 0.03 * 0.02;
  EXPECT_LT(found.modes[5].frequency, 0.2 * found.modes[6].frequency);
  const double bounce = std::sqrt(1e5 / mass) / (2 * std::numbers::pi);
  EXPECT_TRUE(
      std::ranges::any_of(found.modes, [&](const Mode& mode) { return std::abs(mode.frequency / bounce - 1) < 0.02; }));
}

TEST(Modes, AreOrthonormalInMass) {
  VibratingBody body = vibrating_bar();
  const Modes found = body.find({.count = 8});
  const motion::FiniteElementDynamics dynamics(body.scene, body.part, body.attachments);
  for (std::size_t i = 0; i < found.modes.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double product = 0.0;
      for (std::size_t c = 0; c < found.modes[i].shape.size(); ++c) {
        product += dynamics.model(0).masses()[c / 3] * found.modes[i].shape[c] * found.modes[j].shape[c];
      }
      EXPECT_NEAR(total(product), i == j ? 1.0 : 0.0, 1e-9) << i << " " << j;
    }
  }
}

TEST(Modes, LargestComponentIsPositive) {
  for (const Mode& mode : vibrating_bar().find({.count = 8}).modes) {
    double extremes[2] = {*std::ranges::max_element(mode.shape), -*std::ranges::min_element(mode.shape)};
    MPI_Allreduce(MPI_IN_PLACE, extremes, 2, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    EXPECT_GT(extremes[0], 0.999 * extremes[1]);
  }
}

TEST(Modes, AreTheSameOnAnyNumberOfRanks) {
  for (const MassMatrix mass : {MassMatrix::lumped, MassMatrix::consistent}) {
    VibratingBody body = vibrating_bar();
    const Modes together = body.find({.count = 8, .mass = mass});
    const mesh::Part part = body.part;
    const Modes alone = body.find({.count = 8, .mass = mass}, MPI_COMM_SELF);
    for (std::size_t i = 0; i < 8; ++i) {
      const Mode& mode = together.modes[i];
      EXPECT_NEAR(mode.frequency / alone.modes[i].frequency, 1, 1e-9);
      for (std::size_t c = 0; c < mode.shape.size(); ++c) {
        const auto global = static_cast<std::size_t>(3 * part.node_ids[c / 3]) + c % 3;
        ASSERT_NEAR(mode.shape[c], alone.modes[i].shape[global], 1e-6) << "mode " << i << ", component " << global;
      }
    }
  }
}

TEST(Modes, AreDampedByMaterialAndSupports) {
  VibratingBody body = vibrating_bar();
  body.scene.materials[0].damping = {.mass = 6.0, .stiffness = 3e-8};
  for (const Mode& mode : body.find({.count = 4}).modes) {
    const double w = 2 * std::numbers::pi * mode.frequency;
    EXPECT_NEAR(mode.damping_ratio, 6.0 / (2 * w) + 3e-8 * w / 2, 1e-6 * mode.damping_ratio);
    EXPECT_NEAR(mode.decay_time, std::log(1000) / (mode.damping_ratio * w), 1e-12);
  }
  // A stiff body on soft pads everywhere: the springs strain no material, and the dashpots' share is c/m.
  body.scene.materials[0].damping = {.mass = 0.0, .stiffness = 1e-3};
  body.scene.bodies[0].supports.push_back({"pad", {.at = {0.1, 0.015, 0}, .radius = 1.0, .where = {}}, 1e3, 2.0});
  const double mass = 7850 * 0.2 * 0.03 * 0.02;
  const Mode bounce = body.find({.count = 1}).modes[0];
  EXPECT_NEAR(bounce.damping_ratio, 2.0 / (2 * std::sqrt(1e3 * mass)), 0.1 * bounce.damping_ratio);
}

TEST(Modes, AboveCriticalDampingDecayByTheirSlowerMotion) {
  VibratingBody body = vibrating_bar();
  body.scene.materials[0].damping = {.mass = 0.0, .stiffness = 2e-3};
  const Mode mode = body.find({.count = 1}).modes[0];
  ASSERT_GT(mode.damping_ratio, 1.5);
  const double w = 2 * std::numbers::pi * mode.frequency;
  const double rate = std::log(1000) / mode.decay_time;  // exp(-rate t) solves q'' + 2 zeta w q' + w^2 q = 0
  EXPECT_NEAR(rate * rate - 2 * mode.damping_ratio * w * rate + w * w, 0.0, 1e-9 * w * w);
  EXPECT_LT(rate, w) << "the other root dies away sooner";
}

TEST(Modes, OfALossFactorDecayByIt) {
  VibratingBody body = vibrating_bar();
  const Modes lossless = body.find({.count = 4});
  body.scene.materials[0].damping.loss = {0.02, {1000, 20000}, {}, {}};
  const Modes lossy = body.find({.count = 4});
  const solid::Relaxation relaxation = solid::fit_relaxation(*body.scene.materials[0].damping.loss);
  for (std::size_t mode = 0; mode < 4; ++mode) {
    const double frequency = lossy.modes[mode].frequency;
    EXPECT_NEAR(lossy.modes[mode].damping_ratio / 0.01, 1, 0.05);
    EXPECT_NEAR(lossy.modes[mode].decay_time * std::numbers::pi * frequency * 0.02, std::log(1000),
                0.05 * std::log(1000));
    const double stiffer = relaxation.modulus(2 * std::numbers::pi * frequency).real();
    EXPECT_NEAR(frequency / lossless.modes[mode].frequency, std::sqrt(stiffer), 1e-4);
  }
  EXPECT_LT(lossy.modes[0].frequency, lossless.modes[0].frequency) << "below the middle of the band, 4.5 kHz";
  EXPECT_GT(lossy.modes[3].frequency, lossless.modes[3].frequency) << "above it";
  // Springs strain no material.
  body.scene.bodies[0].supports.push_back({"pad", {.at = {0.1, 0.015, 0}, .radius = 1.0, .where = {}}, 1e6, 0});
  EXPECT_LT(body.find({.count = 1}).modes[0].damping_ratio, 0.1 * 0.01);
}

TEST(Modes, RefuseWhatCannotBe) {
  VibratingBody body = block(element::tet4, {0.1, 0.1, 0.1}, {2, 1, 1});
  EXPECT_THAT(body.refusal({.count = 31}), HasSubstr("no more than 30 modes"));
  EXPECT_THAT(body.refusal({.count = 1, .shift = 0.0}), HasSubstr("can move rigidly in 6 ways"));
  body.fix("rim");
  EXPECT_THAT(body.refusal({.count = 1}), HasSubstr("all of it is held"));
}

}  // namespace
}  // namespace idiophone::eigenmodes
