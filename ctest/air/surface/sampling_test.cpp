#include "idiophone/air/surface/sampling.hpp"

#include <gtest/gtest.h>

#include "ranks.hpp"

namespace idiophone::surface {
namespace {

ON_RANKS(1);

TEST(Sampling, ReadsTwelveTimesAPeriodOfTheHighestFrequency) {
  EXPECT_EQ(choose_steps_per_read(24, 44100, 22050.0), 4);
  EXPECT_EQ(choose_steps_per_read(230, 44100, 22050.0), 23);  // 38 would do, but the divisors are 1 2 5 10 23 46 ...
  EXPECT_EQ(choose_steps_per_read(227, 44100, 22050.0), 1);   // prime
  EXPECT_EQ(choose_steps_per_read(24, 44100, 5000.0), 12);
  EXPECT_EQ(choose_steps_per_read(3, 44100, 22050.0), 1);  // too coarse already
}

TEST(Sampling, HasThePapersHalfWidth) {
  const Sampling sampling{.rate = 44100, .steps_per_sample = 23};  // dt = 1/(23 44100): 3/(22050 dt) = 138
  EXPECT_EQ(sampling.half_width(), 138);
  EXPECT_EQ(sampling.latency(), 6);
  const Sampling wide{.rate = 44100, .steps_per_sample = 10, .max_frequency = 20000.0};  // 66.15
  EXPECT_EQ(wide.half_width(), 67);
  EXPECT_EQ(wide.latency(), 7);
}

}  // namespace
}  // namespace idiophone::surface
