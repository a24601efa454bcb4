// Springs, hinges and bolts: what rigid bodies feel, and how two bodies vibrate on them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "assembly.hpp"
#include "joined_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::joints {
namespace {

/// Turns the second body about an axis through a point, then shifts it; the first one rests.
void move_second(JoinedBlocks& blocks, const Vector3& point, const Eigen::AngleAxisd& turn, const Vector3& shift) {
  for (Index node = blocks.part.bodies[1].owned_begin; node < blocks.part.bodies[1].owned_end; ++node) {
    const Vector3 arm = blocks.part.reference[node] - point;
    Vector3::Map(blocks.state[node].displacement) = turn * arm - arm + shift;
  }
}

Eigen::AngleAxisd no_turn() {
  return {0.0, Vector3::UnitX()};
}

/// Moment of the forces on the second body about a point, N m.
Vector3 moment_on_second(const JoinedBlocks& blocks, const Vector3& point) {
  const std::vector<solid::NodeForce> forces = blocks.forces();
  Vector3 moment = Vector3::Zero();
  for (Index node = blocks.part.bodies[1].owned_begin; node < blocks.part.bodies[1].owned_end; ++node) {
    const Vector3 place = blocks.part.reference[node] + Vector3(blocks.state[node].displacement);
    moment += (place - point).cross(Vector3(forces[node].component));
  }
  return moment;
}

double square(double x) {
  return x * x;
}

/// What find_joints() says when it refuses; empty when it does not.
std::string refusal(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  try {
    (void)find_joints(solids, meshes);
  } catch (const deck::DeckError& error) {
    return error.what();
  }
  return "";
}

/// A spring between the sides of two blocks at one place: as of a sleeve in a sleeve, they face all ways.
struct Sleeves {
  Sleeves(double axial, double lateral) {
    scene::Joint joint = JoinedBlocks::joint_of("spring");
    joint.surfaces = {scene::JoinedSurface{0, "rim", {}}, scene::JoinedSurface{1, "rim", {}}};
    joint.stiffness = {axial, lateral};
    joint.where = {"sleeves.yaml", 7, 3};
    scene.materials = {{"steel", 2e11, 0.3, 7850, {0, 0}, {}}};
    scene.bodies.resize(2);
    scene.joints = {joint};
  }

  std::vector<mesh::Mesh> meshes{2, support::block_mesh(element::tet10, {0.03, 0.03, 0.02}, {2, 2, 1})};
  scene::Scene scene;
};

ON_RANKS(1);

TEST(Spring, BetweenSleevesHasOneStiffness) {
  Sleeves sleeves(1e6, 1e6);
  const std::vector<MeshedJoint> meshed = find_joints(sleeves.scene, sleeves.meshes);
  EXPECT_EQ(meshed[0].largest_distance(), 0.0);
  for (const NodeWeight& weight : meshed[0].weights) {
    EXPECT_TRUE(std::isfinite(weight.value) && std::isfinite(weight.slope[0]) && std::isfinite(weight.slope[1]));
  }
}

TEST(Spring, BetweenSleevesHasNoDirection) {
  Sleeves sleeves(1e6, 1e5);
  EXPECT_THAT(refusal(sleeves.scene, sleeves.meshes),
              testing::StartsWith("sleeves.yaml:7:3: joints.spring: the middles of 'rim' and 'rim' are at the same "
                                  "place, and the surfaces face all ways, so that axial and lateral have no "
                                  "direction: give one number as stiffness, or at and radius"));
  for (Vector3& node : sleeves.meshes[1].nodes) {
    node += Vector3(1e-4, 2e-4, 0);  // as much as meshes of round sleeves differ
  }
  EXPECT_THAT(refusal(sleeves.scene, sleeves.meshes), testing::HasSubstr("at the same place"));
  sleeves.scene.joints[0].place = scene::PatchPlace{{0.03, 0.015, 0.01}, 0.0, {}};
  EXPECT_EQ(refusal(sleeves.scene, sleeves.meshes), "");  // one face has a normal
}

TEST(Spring, PullsAlongAndAcrossTheLineBetweenTheMiddles) {
  JoinedBlocks blocks(MPI_COMM_SELF, JoinedBlocks::joint_of("spring"));
  EXPECT_NEAR(blocks.meshed[0].largest_distance(), JoinedBlocks::gap, 1e-12);
  move_second(blocks, Vector3::Zero(), no_turn(), {1e-4, 2e-4, 3e-4});
  EXPECT_NEAR(blocks.energy(), 0.5 * (3e8 * 1e-8 + 1e8 * (4e-8 + 9e-8)), 1e-9);
}

TEST(Spring, HoldsThePartAroundAPlace) {
  scene::Joint joint = JoinedBlocks::joint_of("spring");
  joint.place = scene::PatchPlace{{0.1, 0.03, 0.02}, 0.0, {}};
  const JoinedBlocks blocks(MPI_COMM_SELF, joint);
  const Index in_one_tetrahedron = blocks.meshed[0].points[0].second_begin;
  EXPECT_EQ(in_one_tetrahedron, 10);
  EXPECT_EQ(blocks.meshed[0].points[0].end - in_one_tetrahedron, 75);  // of one hexahedron of orders 4 and 2
}

TEST(Hinge, TurnsFreelyAboutItsAxis) {
  JoinedBlocks blocks(MPI_COMM_SELF, JoinedBlocks::joint_of("hinge"));
  move_second(blocks, blocks.joint.axis.begin, {1.0, Vector3::UnitY()}, Vector3::Zero());
  EXPECT_LT(blocks.energy(), 1e-15 * blocks.joint.stiffness->normal);  // 1e-15 m2: of nanometres
}

TEST(Hinge, ResistsAllOtherMotion) {
  const scene::Joint joint = JoinedBlocks::joint_of("hinge");
  const double stiffness = joint.stiffness->normal;
  const double length = (joint.axis.end - joint.axis.begin).norm();
  const Vector3 middle = (joint.axis.end + joint.axis.begin) / 2;
  JoinedBlocks blocks(MPI_COMM_SELF, joint);
  for (int axis = 0; axis < 3; ++axis) {
    move_second(blocks, middle, no_turn(), 1e-3 * Vector3::Unit(axis));
    EXPECT_NEAR(blocks.energy(), stiffness * 1e-6, 1e-9 * stiffness * 1e-6);  // of two ends
  }
  for (const int axis : {0, 2}) {
    move_second(blocks, middle, {0.3, Vector3::Unit(axis)}, Vector3::Zero());
    const double expected = stiffness * square(length * std::sin(0.15));
    EXPECT_NEAR(blocks.energy(), expected, 1e-9 * expected);
  }
}

TEST(Hinge, PullsBackByItsStiffnessAgainstTurning) {
  JoinedBlocks blocks(MPI_COMM_SELF, JoinedBlocks::joint_of("door"));
  const double stiffness = blocks.joint.turning->stiffness;
  const double angle = 0.4;
  move_second(blocks, blocks.joint.axis.begin, {angle, Vector3::UnitY()}, Vector3::Zero());
  EXPECT_NEAR(blocks.energy(), stiffness * square(std::sin(angle)) / 2, 1e-9 * stiffness);
  const Vector3 moment = moment_on_second(blocks, blocks.joint.axis.begin);
  EXPECT_NEAR(moment.y(), -stiffness * std::sin(angle) * std::cos(angle), 1e-7 * stiffness);
  EXPECT_NEAR(std::hypot(moment.x(), moment.z()), 0.0, 1e-7 * stiffness);
}

TEST(Bolt, JoinsWhatLiesUnderItsWasher) {
  const JoinedBlocks blocks(MPI_COMM_SELF, JoinedBlocks::joint_of("bolt"));
  const double washer = std::numbers::pi * square(0.008);
  EXPECT_NEAR(blocks.meshed[0].area(), washer, 0.25 * washer);  // to the middle between points of quadrature
  EXPECT_EQ(blocks.meshed[0].normal, 3e12);
}

TEST(Links, RefuseWhatTheyCannotHold) {
  const auto refusal = [](const scene::Joint& joint) {
    JoinedBlocks blocks;
    blocks.scene.joints = {joint};
    return joints::refusal(blocks.scene, blocks.meshes);
  };
  scene::Joint hinge = JoinedBlocks::joint_of("hinge");
  hinge.axis.end.y() = 1.0;
  EXPECT_THAT(refusal(hinge),
              testing::HasSubstr("joints.hinge: the end [0.1, 1, 0.012] of the axis is 0.986 m from the "
                                 "middle of 'x1'"));
  scene::Joint bolt = JoinedBlocks::joint_of("bolt");
  bolt.place->radius = 1e-6;
  EXPECT_THAT(refusal(bolt), testing::HasSubstr("joints.bolt: no part of the two surfaces under the washer faces"));
  scene::Joint spring = JoinedBlocks::joint_of("spring");
  spring.surfaces[0].group = "end";
  EXPECT_THAT(refusal(spring), testing::HasSubstr("the mesh has no group 'end'"));
  spring = JoinedBlocks::joint_of("spring");
  spring.place = scene::PatchPlace{{0.1, 0.015, 0.03}, 0.0, {"spring.yaml", 4, 9}};
  EXPECT_EQ(refusal(spring), "");
  spring.place->at = {100, 15, 10};  // in mm
  EXPECT_THAT(refusal(spring),
              testing::StartsWith("spring.yaml:4:9: joints.spring: the place [100, 15, 10] is 101 m from the nearer of "
                                  "'x1' and 'x0', more than a quarter of the size of the body"));
}

}  // namespace
}  // namespace idiophone::joints

namespace idiophone::eigenmodes {
namespace {

/// Two equal blocks of steel, nearly rigid beside what ties them.
Assembly linked_blocks(scene::Joint joint) {
  Assembly blocks;
  const mesh::Mesh block = support::block_mesh(element::hex(2, 2), {0.1, 0.03, 0.02}, {2, 1, 1});
  blocks.add(block, Vector3::Zero());
  blocks.add(block, {0.15, 0, 0});
  joint.surfaces = {scene::JoinedSurface{0, "x1", {}}, scene::JoinedSurface{1, "x0", {}}};
  blocks.scene.joints = {joint};
  return blocks;
}

scene::Joint spring(double axial, double lateral) {
  scene::Joint joint;
  joint.type = scene::JointType::spring;
  joint.stiffness = {axial, lateral};
  joint.damping = 1e-4;
  return joint;
}

/// Its axis is that of both blocks.
scene::Joint pivot(std::optional<scene::HingeTurning> turning) {
  scene::Joint joint;
  joint.type = scene::JointType::hinge;
  joint.axis = {{0.11, 0.015, 0.01}, {0.14, 0.015, 0.01}};
  joint.turning = turning;
  return joint;
}

constexpr double mass = 7850 * 0.1 * 0.03 * 0.02;                    // kg, of a block
constexpr double inertia = mass * (0.03 * 0.03 + 0.02 * 0.02) / 12;  // kg m2, about its long axis

ON_RANKS(1, 3);

TEST(LinkedModes, BlocksOnASpringMoveAgainstEachOther) {
  const double stiffness = 1e4;  // N/m
  const Modes found = linked_blocks(spring(stiffness, 0.0)).find(1);
  EXPECT_EQ(found.rigid_motions, 11);
  const double frequency = std::sqrt(stiffness / (mass / 2));
  EXPECT_NEAR(2 * std::numbers::pi * found.modes[0].frequency, frequency, 1e-4 * frequency);
  EXPECT_NEAR(found.modes[0].damping_ratio, 1e-4 * frequency / 2, 1e-4 * 1e-4 * frequency);
  EXPECT_NEAR(found.modes[0].decay_time, 3 * std::numbers::ln10 / (1e-4 * frequency * frequency / 2),
              1e-3 * found.modes[0].decay_time);
}

TEST(LinkedModes, ASpringTiesThreeOfSixMotions) {
  const Modes found = linked_blocks(spring(1e4, 1e4)).find(3);
  EXPECT_EQ(found.rigid_motions, 9);  // six of all, and three turns about the middle of the second face
}

TEST(LinkedModes, BlocksOnAPivotTurnFreely) {
  const Modes found = linked_blocks(pivot(std::nullopt)).find(1);
  EXPECT_EQ(found.rigid_motions, 7);
}

TEST(LinkedModes, BlocksOnAPivotThatResistsTurnAgainstEachOther) {
  const double stiffness = 0.1;  // N m/rad
  const Modes found = linked_blocks(pivot(scene::HingeTurning{stiffness, 1e-4})).find(1);
  EXPECT_EQ(found.rigid_motions, 6);
  const double frequency = std::sqrt(stiffness / (inertia / 2));
  EXPECT_NEAR(2 * std::numbers::pi * found.modes[0].frequency, frequency, 1e-4 * frequency);
  EXPECT_NEAR(found.modes[0].damping_ratio, 1e-4 * frequency / 2, 1e-4 * 1e-4 * frequency);
}

TEST(LinkedModes, ABarBoltedOverItsWholeFaceIsOneBar) {
  scene::Joint bolt;
  bolt.type = scene::JointType::bolt;
  bolt.place = scene::PatchPlace{{0.15, 0.01, 0.005}, 1.0, {}};
  bolt.surfaces = {scene::JoinedSurface{0, "x1", {}}, scene::JoinedSurface{1, "x0", {}}};
  Assembly whole, halves;
  whole.add(support::block_mesh(element::hex(4, 2), {0.4, 0.02, 0.01}, {8, 1, 1}), Vector3::Zero());
  halves.add(support::block_mesh(element::hex(4, 2), {0.15, 0.02, 0.01}, {3, 1, 1}), Vector3::Zero());
  halves.add(support::block_mesh(element::hex(4, 2), {0.25, 0.02, 0.01}, {5, 1, 1}), {0.15, 0, 0});
  halves.scene.joints = {bolt};
  const Modes expected = whole.find(3);
  const Modes bolted = halves.find(3);
  EXPECT_EQ(bolted.rigid_motions, 6);
  for (std::size_t mode = 0; mode < expected.modes.size(); ++mode) {
    EXPECT_LT(std::abs(1200 * std::log2(bolted.modes[mode].frequency / expected.modes[mode].frequency)), 1.0) << mode;
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
