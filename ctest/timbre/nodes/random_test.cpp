// Random numbers that are functions of a counter.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "idiophone/timbre/nodes/random.hpp"

#include "ranks.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(RandomNumbers, AreThoseOfSplitMix64) {  // the published sequence of the seed 1234567
  constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;
  EXPECT_EQ(scrambled(1234567U), 6457827717110365317U);
  EXPECT_EQ(scrambled(1234567U + step), 3203168211198807973U);
  EXPECT_EQ(scrambled(1234567U + 2U * step), 9817491932198370423U);
}

TEST(RandomNumbers, HaveTheirMoments) {
  const Random random(11);
  constexpr int count = 100000;
  double mean = 0.0, square = 0.0, normal = 0.0, normal_square = 0.0, fourth = 0.0;
  for (int i = 0; i < count; ++i) {
    const double even = random.uniform(i), bell = random.normal(i);
    ASSERT_GE(even, 0.0);
    ASSERT_LT(even, 1.0);
    mean += even / count;
    square += even * even / count;
    normal += bell / count;
    normal_square += bell * bell / count;
    fourth += bell * bell * bell * bell / count;
  }
  EXPECT_NEAR(mean, 0.5, 0.005);
  EXPECT_NEAR(square, 1.0 / 3.0, 0.005);
  EXPECT_NEAR(normal, 0.0, 0.015);
  EXPECT_NEAR(normal_square, 1.0, 0.02);
  EXPECT_NEAR(fourth, 3.0, 0.15);
}

TEST(RandomNumbers, DependOnTheCounterAlone) {
  const Random random(3), again(3), other(4);
  const double later = random.uniform(1000);
  EXPECT_EQ(again.uniform(1000), later);
  EXPECT_NE(other.uniform(1000), later);
  EXPECT_NE(random.uniform(1001), later);
}

TEST(RandomNumbers, HaveSeedsOfAllNumbers) {
  std::set<std::uint64_t> seeds;
  for (const double number : {0.0, 1.0, -1.0, 0.5, 1e300, -1e300}) {
    seeds.insert(seed_of(number));
  }
  EXPECT_EQ(seeds.size(), 6U);
  EXPECT_EQ(seed_of(3.0), 3U);
  EXPECT_NE(joined_seed(1, 2), joined_seed(2, 1));
}

}  // namespace idiophone::timbre
