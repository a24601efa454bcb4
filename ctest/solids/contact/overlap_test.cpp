#include <gtest/gtest.h>

#include <numbers>

#include "overlapping_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

using element::Type;
using Shape = scene::Obstacle::Shape;

double overlap_of(Block& block, const RigidShape& shape) {
  std::vector<Index> parts(shape.boxes.size());
  std::iota(parts.begin(), parts.end(), 0);
  Interaction interaction({}, 1.0, 1.0, block.side, shape);
  interaction.choose_candidates(block.cells(), parts, 0.0);
  compute(interaction);
  return interaction.motion().overlap;
}

/// A block of two layers: all of it is skin.
Block block_around(const Vector3& centre, const Vector3& size) {
  return {element::tet4, size, {2, 2, 2}, [=](const Vector3& x) { return Vector3(x - size / 2 + centre); }};
}

ON_RANKS(1);

TEST(Overlap, OfTwoBlocksIsTheirCommonBlock) {
  Block first = block_around({0, 0, 0}, {2, 1, 1});
  Block second = block_around({1.3, 0.2, 0.4}, {1, 1.5, 0.5});
  Interaction interaction({}, 1.0, 1.0, first.side, second.side);
  interaction.choose_candidates(first.cells(), second.cells(), 0.0);
  compute(interaction);
  EXPECT_NEAR(interaction.motion().overlap, 0.2 * 1.0 * 0.35, 1e-14);
}

TEST(Overlap, OfAlignedBlocksWithCommonPlanesIsRight) {
  Block first = block_around({0, 0, 0}, {1, 1, 1});
  Block second = block_around({0, 0, 0.9}, {1, 1, 1});
  Interaction interaction({}, 1.0, 1.0, first.side, second.side);
  interaction.choose_candidates(first.cells(), second.cells(), 0.0);
  compute(interaction);
  EXPECT_NEAR(interaction.motion().overlap, 0.1, 1e-14);
}

TEST(Overlap, WithEveryShapeIsTheShapesVolume) {
  const Vector3 at(0.3, -0.2, 0.1);
  Block block = block_around(at, {4, 4, 4});
  scene::Obstacle obstacle;
  obstacle.at = at;
  obstacle.shape = Shape::sphere;
  obstacle.radius = 0.7;
  EXPECT_NEAR(overlap_of(block, make_shape(obstacle)), 4 * std::numbers::pi / 3 * 0.343, 1e-12);
  obstacle.shape = Shape::cylinder;
  obstacle.direction = Vector3(1, 2, 2) / 3;
  obstacle.length = 0.9;
  EXPECT_NEAR(overlap_of(block, make_shape(obstacle)), std::numbers::pi * 0.49 * 0.9, 1e-12);
  obstacle.shape = Shape::box;
  obstacle.size = {1, 0.5, 0.25};
  obstacle.rotation = {0.3, -0.2, 0.9};
  EXPECT_NEAR(overlap_of(block, make_shape(obstacle)), 0.125, 1e-12);
  obstacle.shape = Shape::half_space;
  EXPECT_NEAR(overlap_of(block, make_shape(obstacle)), 32, 1e-10);
}

TEST(Overlap, OfCellsThatOnlyTouchIsNothing) {
  Block first = block_around({0, 0, 0}, {1, 1, 1});
  Block second = block_around({0, 0, 1}, {1, 1, 1});
  Interaction interaction({}, 1.0, 1.0, first.side, second.side);
  interaction.choose_candidates(first.cells(), second.cells(), 0.0);
  compute(interaction);
  EXPECT_LT(interaction.motion().overlap, 1e-15);
  EXPECT_LT(interaction.energy(), 1e-25);
}

}  // namespace
}  // namespace idiophone::contact
