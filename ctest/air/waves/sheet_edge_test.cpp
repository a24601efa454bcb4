#include "sheet_edge.hpp"
#include "ranks.hpp"

#include <gtest/gtest.h>

namespace idiophone::waves {
namespace {

/// A sheet between two layers of an axis that covers the first sub-voxels of each line in it.
Mask sheet(std::size_t axis, int first_layer, int last_layer, int covered) {
  std::uint64_t layer = 0;
  for (int v = 0; v < voxels; ++v) {
    layer |= ((std::uint64_t{1} << covered) - 1) << (voxels * v);
  }
  Mask layers{};
  for (int k = first_layer; k <= last_layer; ++k) {
    layers[k] = layer;
  }
  return mask_of_layers(layers, axis);
}

std::optional<DividedPart> divided(const Mask& solid) {
  return divide_at_edge(complement(solid), solid);
}

ON_RANKS(1);

TEST(SubVoxels, AreMadeOfLayers) {
  Mask one{};
  one[2] = std::uint64_t{1} << (8 * 3 + 5);
  for (const std::size_t axis : {0U, 1U, 2U}) {
    EXPECT_EQ(mask_of_layers(layers_along(one, axis), axis), one);
  }
}

TEST(SheetEdge, HasAirAboveAndBelow) {
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const auto parts = divided(sheet(axis, 3, 4, 6));
    ASSERT_TRUE(parts);
    EXPECT_EQ(count(parts->above), 3 * 64 + 16);
    EXPECT_EQ(count(parts->below), 3 * 64 + 16);
    EXPECT_EQ(overlap(parts->above, parts->below), 0);
    EXPECT_EQ(layers_along(parts->above, axis)[7], all_bits);
    EXPECT_EQ(layers_along(parts->below, axis)[0], all_bits);
  }
}

TEST(SheetEdge, ClosesAsTheSheetGrows) {
  float opening = 10.0F;
  for (int covered = 4; covered < voxels; ++covered) {
    const auto parts = divided(sheet(2, 3, 4, covered));
    ASSERT_TRUE(parts);
    EXPECT_LT(parts->opening, opening);
    opening = parts->opening;
  }
  // Half a cell is covered: the opening shortens the slit by 0.646 cells and less, against a resistance of 1.657.
  const double shortened = 0.646447 - 0.25 / 6.0;
  EXPECT_NEAR(divided(sheet(2, 3, 4, 4))->opening, shortened / ((1.0 - shortened) * 1.656854), 1e-4);
}

TEST(SheetEdge, IsNoneWhereLittleIsCoveredOrTheSolidIsThick) {
  EXPECT_FALSE(divided(sheet(2, 3, 4, 1)));
  EXPECT_FALSE(divided(sheet(2, 1, 6, 6)));
  EXPECT_FALSE(divided(sheet(2, 0, 3, 6)));  // a corner
}

TEST(SheetEdge, OfATiltedSheetIsDividedAlongIt) {
  Mask solid{};
  for (int x = 0; x < 6; ++x) {
    const int z = 1 + x / 2;
    for (int y = 0; y < voxels; ++y) {
      solid[z] |= std::uint64_t{1} << (voxels * y + x);
    }
  }
  const auto parts = divided(solid);
  ASSERT_TRUE(parts);
  EXPECT_TRUE(contains(parts->above, {7, 4, 5}));
  EXPECT_TRUE(contains(parts->below, {7, 4, 3}));
  EXPECT_TRUE(contains(parts->above, {0, 4, 2}));
  EXPECT_TRUE(contains(parts->below, {0, 4, 0}));
}

}  // namespace
}  // namespace idiophone::waves
