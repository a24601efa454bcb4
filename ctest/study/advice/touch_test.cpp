#include "idiophone/study/advice/touch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "idiophone/scene/scene.hpp"
#include "ranks.hpp"

namespace idiophone::advice {
namespace {

constexpr double height = 0.15;  // m
const Gap above_floor{.width = height, .across = {0, 0, -height}, .normal = {0, 0, 1}};

scene::Contact with_floor() {
  scene::Contact contact;
  contact.obstacle = 0;
  return contact;
}

scene::Contact with_partner() {
  scene::Contact contact;
  contact.other = 1;
  return contact;
}

/// Two free bodies that fall, with a contact between the first one and a floor.
scene::Scene falling() {
  scene::Scene scene;
  scene.bodies.resize(2);
  scene.obstacles.resize(1);
  scene.gravity = {0, 0, -9.81};
  scene.contacts.push_back(with_floor());
  return scene;
}

TouchingTime time_of(const scene::Scene& scene, const Gap& gap) {
  return touching_time(scene, scene.contacts[0], gap, 1e-5, 1.0);
}

ON_RANKS(1);

TEST(TouchingTime, BeginsWhereAFallEnds) {
  scene::Scene scene = falling();
  const double begin = time_of(scene, above_floor).begin;
  EXPECT_NEAR(begin, std::sqrt(2 * height / 9.81), 1e-12);
  EXPECT_NEAR(time_of(scene, above_floor).duration, 1 - begin, 1e-12) << "it may bounce, roll or lie still";
  EXPECT_FALSE(time_of(scene, above_floor).is_certain);
  scene.bodies[0].velocity = {0, 0, 2};
  EXPECT_NEAR(time_of(scene, above_floor).begin, (2 + std::sqrt(4 + 2 * 9.81 * height)) / 9.81, 1e-12) << "thrown up";
  scene.time.duration = 0.1;
  scene.bodies[0].velocity = {0, 0, 20};
  EXPECT_EQ(time_of(scene, above_floor).duration, 0.0) << "the run ends before it comes back";
}

TEST(TouchingTime, IsShortInFlight) {
  scene::Scene scene = falling();
  scene.gravity.setZero();
  EXPECT_EQ(time_of(scene, above_floor).duration, 0.0) << "it stands still";
  scene.bodies[0].velocity = {0, 0, -1.5};
  EXPECT_NEAR(time_of(scene, above_floor).begin, 0.1, 1e-12);
  EXPECT_EQ(time_of(scene, above_floor).duration, 1e-3);
  scene.contacts[0] = with_partner();
  scene.bodies[1].velocity = {0, 0, 1.5};
  EXPECT_NEAR(time_of(scene, above_floor).begin, 0.05, 1e-12) << "both come nearer";
  scene.gravity = {0, 0, -9.81};
  EXPECT_NEAR(time_of(scene, above_floor).begin, 0.05, 1e-12) << "both fall alike";
}

TEST(TouchingTime, IsCertainWhereNothingPartsTheSides) {
  scene::Scene scene = falling();
  EXPECT_TRUE(time_of(scene, {}).is_certain) << "it lies on the floor";
  EXPECT_EQ(time_of(scene, {}).duration, 1.0);
  scene.bodies[0].supports.resize(1);
  EXPECT_TRUE(time_of(scene, {}).is_certain) << "held beside its partner";
  EXPECT_FALSE(time_of(scene, above_floor).is_certain);
  EXPECT_EQ(time_of(scene, above_floor).duration, 1.0) << "it may come there by vibration";
  scene.bodies[0].supports.clear();
  scene.pulses.resize(1);
  EXPECT_EQ(time_of(scene, above_floor).begin, 0.0) << "a load may move it there at once";
}

TEST(TouchingShare, IsSmallForHardBodies) {
  scene::Material steel, rubber;
  steel.young = 2e11;
  steel.density = 7850;
  rubber.young = 4e6;
  rubber.density = 1000;
  EXPECT_NEAR(touching_share(steel, 9.81, 0.24), 9.81 * 0.24 / (5048 * 0.02), 1e-4);
  EXPECT_EQ(touching_share(rubber, 9.81, 0.3), 1.0);
}

/// A tetrahedron with one face at z = 0.01, seen from below.
contact::Skin tetrahedron(Index first_node) {
  contact::Skin skin;
  skin.nodes = {first_node, first_node + 1, first_node + 2, first_node + 3};
  skin.areas = {1, 1, 1, 1};
  skin.cells = {{0, 1, 2, 3}};
  skin.exterior = {{1, 1, 1, 1}};
  return skin;
}

TEST(Gap, LiesBetweenTheNearestPlaces) {
  const std::vector<Vector3> positions = {{0, 0, 0.01}, {1, 0, 0.02}, {0, 1, 0.02}, {0, 0, 1},
                                          {0, 0, 0},    {1, 0, -1},   {-1, -1, -1}, {-1, 1, -1}};
  contact::ContactSurfaces surfaces;
  surfaces.skins = {tetrahedron(0), tetrahedron(4)};
  surfaces.shapes = {contact::make_shape(scene::Obstacle())};
  const Gap to_floor = find_gap(with_floor(), surfaces, positions);
  EXPECT_NEAR(to_floor.width, 0.01, 1e-15);
  EXPECT_TRUE(to_floor.across.isApprox(Vector3(0, 0, -0.01)));
  EXPECT_TRUE(to_floor.normal.isApprox(Vector3::UnitZ()));
  const Gap to_body = find_gap(with_partner(), surfaces, positions);
  EXPECT_NEAR(to_body.width, 0.01 * to_body.normal.z(), 1e-15);
  EXPECT_TRUE(to_body.across.isApprox(Vector3(0, 0, -0.01)));
  EXPECT_GT(to_body.normal.z(), 0.8) << "out of the partner";
}

}  // namespace
}  // namespace idiophone::advice
