#include "blocks.hpp"
#include "ranks.hpp"

#include <gtest/gtest.h>

namespace idiophone::loop {
namespace {

ON_RANKS(1);

TEST(FirstBlock, IsShortWhereASampleTakesLong) {
  EXPECT_EQ(first_block(30, 680), 16);
  EXPECT_EQ(first_block(1, 0), 16);
  EXPECT_EQ(first_block(2037, 80), 4) << "many steps";
  EXPECT_EQ(first_block(100, 20'000), 5) << "many nodes";
  EXPECT_EQ(first_block(100'000, 1'000'000'000), 1);
}

TEST(NextBlock, TakesAboutTwoSeconds) {
  EXPECT_EQ(next_block(100, 1.0, longest_block), 200);
  EXPECT_EQ(next_block(100, 4.0, longest_block), 50);
}

TEST(NextBlock, ChangesByAFactorOfFourAtTheMost) {
  EXPECT_EQ(next_block(100, 1e-3, longest_block), 400);
  EXPECT_EQ(next_block(100, 0.0, longest_block), 400);
  EXPECT_EQ(next_block(100, 1e6, longest_block), 25);
}

TEST(NextBlock, HasAtLeastOneSampleAndAtMostTheLongest) {
  EXPECT_EQ(next_block(1, 100.0, longest_block), 1);
  EXPECT_EQ(next_block(longest_block, 0.1, longest_block), longest_block);
  EXPECT_EQ(next_block(100, 0.1, 3), 3);
}

}  // namespace
}  // namespace idiophone::loop
