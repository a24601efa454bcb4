#include "broad_phase.hpp"

#include <gtest/gtest.h>

#include "overlapping_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

constexpr double interval = 1e-3;  // s

/// A block of one-metre cells, 1 x 1 x 4, standing at a height (m).
Block column(double height) {
  return Block(element::tet4, {1, 1, 4}, {1, 1, 4},
               [height](const Vector3& x) { return Vector3(x + Vector3(0, 0, height)); });
}

Bounds bounds_of(const Block& block, std::size_t side, double speed = 0.0) {
  Bounds bounds;
  for (const Vector3& x : block.side.position) {
    bounds.boxes.at(side).extend(x);
  }
  bounds.speed = speed;
  return bounds;
}

LocalSkin local_skin(const Block& block) {
  return find_local_skin(block.skin, support::whole_part(block.mesh));
}

RigidShape floor_shape() {
  scene::Obstacle floor;
  floor.shape = scene::Obstacle::Shape::half_space;
  floor.direction = Vector3::UnitZ();
  return make_shape(floor);
}

ON_RANKS(1);

TEST(BroadPhase, OnlyTheCellsNearAFloorMayTouchIt) {
  Block block = column(0.001);
  const RigidShape floor = floor_shape();
  BroadPhase phase({&block.side}, &floor, interval);
  phase.update(bounds_of(block, 0));
  ASSERT_TRUE(phase.may_touch(bounds_of(block, 0)));
  const std::vector<SkinNode> near = phase.near_nodes(0, local_skin(block));
  EXPECT_EQ(near.size(), 8U);  // of the lowest cell
  for (const SkinNode& node : near) {
    EXPECT_LT(block.side.position[node.place].z(), 1.1);
  }
  EXPECT_EQ(phase.near_parts(), std::vector<Index>{0});
}

TEST(BroadPhase, SkipsUpdatesWhileThePartnerIsFar) {
  const RigidShape floor = floor_shape();
  const auto skipped = [&](double height, double speed) {
    Block block = column(height);
    BroadPhase phase({&block.side}, &floor, interval);
    phase.update(bounds_of(block, 0, speed));
    return phase.updates_to_skip();
  };
  EXPECT_EQ(skipped(0.0, 0.0), 0);
  EXPECT_EQ(skipped(0.05, 0.0), 0);  // within the margin and one interval
  EXPECT_GT(skipped(1.0, 0.0), 10);
  EXPECT_LT(skipped(1.0, 20.0), skipped(1.0, 0.0));
  for (const double speed : {0.0, 3.0, 20.0}) {  // what it travels until the next update leaves it outside the margin
    EXPECT_LT((skipped(1.0, speed) + 1) * interval * (speed + 5.0), 0.9) << speed;
  }
  Block lower = column(0.0);
  Block upper = column(5.0);
  BroadPhase phase({&lower.side, &upper.side}, nullptr, interval);
  Bounds both = bounds_of(lower, 0);
  both.extend(bounds_of(upper, 1));
  phase.update(both);
  EXPECT_GT(phase.updates_to_skip(), 10);
}

TEST(BroadPhase, MarginGrowsWithTheSpeed) {
  Block block = column(0.5);
  const RigidShape floor = floor_shape();
  BroadPhase phase({&block.side}, &floor, interval);
  phase.update(bounds_of(block, 0));
  EXPECT_FALSE(phase.may_touch(bounds_of(block, 0)));
  EXPECT_NEAR(phase.margin(), block.skin.thinnest / 16, 1e-15);
  phase.update(bounds_of(block, 0, 125.0));  // travels an eighth of a metre in the interval
  EXPECT_NEAR(phase.margin(), block.skin.thinnest / 16 + 0.5, 1e-15);
  EXPECT_TRUE(phase.may_touch(bounds_of(block, 0)));
}

TEST(BroadPhase, MarginOfABodyWithItselfGrowsWithTheSpeedOfItsPartsOnly) {
  Block block = column(0.5);
  BroadPhase phase({&block.side}, nullptr, interval);
  Bounds flying = bounds_of(block, 0, 125.0);
  flying.velocities.extend(Vector3(125, 0, 0));
  phase.update(flying);
  EXPECT_NEAR(phase.margin(), block.skin.thinnest / 16, 1e-15);
  flying.velocities.extend(Vector3(121, 0, 3));
  phase.update(flying);
  EXPECT_NEAR(phase.margin(), block.skin.thinnest / 16 + 2 * 5 * interval, 1e-15);
  flying.velocities.extend(Vector3(-125, -125, -125));  // the largest speed is a bound, too
  phase.update(flying);
  EXPECT_NEAR(phase.margin(), block.skin.thinnest / 16 + 0.5, 1e-15);
}

TEST(BroadPhase, TwoBodiesMayTouchWhereTheirBoundsMeet) {
  Block lower = column(0);
  Block upper = column(4.01);
  BroadPhase phase({&lower.side, &upper.side}, nullptr, interval);
  Bounds whole = bounds_of(lower, 0);
  whole.extend(bounds_of(upper, 1));
  phase.update(whole);
  EXPECT_TRUE(phase.may_touch(bounds_of(lower, 0)));
  for (const SkinNode& node : phase.near_nodes(0, local_skin(lower))) {
    EXPECT_GT(lower.side.position[node.place].z(), 2.9);
  }
  whole.boxes[1].translate(Vector3::UnitZ());
  phase.update(whole);
  EXPECT_FALSE(phase.may_touch(bounds_of(lower, 0)));
  EXPECT_FALSE(phase.may_touch(Bounds{}));  // a rank without nodes
}

}  // namespace
}  // namespace idiophone::contact
