// Vectors, keyframes and timers.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "measured.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Vectors, OfRandomNumbersBelongToTheBody) {
  const auto sum = [](std::uint64_t body, std::uint64_t start) {
    return sound_of("(combine (rvector 5 1 2))", 1, {}, {.body_seed = body, .start_seed = start}).front();
  };
  EXPECT_EQ(sum(1, 1), sum(1, 2));
  EXPECT_NE(sum(1, 1), sum(2, 1));
  EXPECT_NEAR(sum(1, 1), 7.5, 2.5);
  EXPECT_NE(mistakes_of("(combine (rvector 2.5 1 2))"), "");
}

TEST(Vectors, CombineAndDampModes) {
  EXPECT_EQ(sound_of("(combine (vector 1 2 3) (vector 1 10 100))", 1).front(), 321.0);
  const auto decay = sound_of("(damp 100 0.01)", 44101);
  EXPECT_NEAR(decay.back(), std::exp(-2.0 * std::numbers::pi), 1e-9);
}

TEST(Keyframes, InterpolateAndHold) {
  const auto at = [](const std::string& word, double time) {
    return sound_of("(keyframe " + word + " 0 0 1 2 2 4)", static_cast<std::size_t>(time * 44100) + 1).back();
  };
  EXPECT_NEAR(at("linear", 0.5), 1.0, 1e-4);
  EXPECT_EQ(at("hold", 0.999), 0.0);
  EXPECT_NEAR(at("cubic", 1.0), 2.0, 1e-3);
  EXPECT_EQ(at("linear", 3.0), 4.0);
  EXPECT_NE(mistakes_of("(keyframe round 0 1)"), "");
  EXPECT_NE(mistakes_of("(keyframe linear 1 1 0 2)"), "");
}

TEST(Vectors, OfRandomNumbersFillTheirRange) {
  const auto number = [](int component) {
    std::string weights;
    for (int i = 0; i < 100; ++i) {
      weights += i == component ? " 1" : " 0";
    }
    return sound_of(fmt::format("(combine (rvector 100 -3 5) (vector{}))", weights), 1).front();
  };
  double mean = 0.0, least = 5.0, most = -3.0;
  for (int i = 0; i < 100; ++i) {
    mean += number(i) / 100.0;
    least = std::min(least, number(i));
    most = std::max(most, number(i));
  }
  EXPECT_GE(least, -3.0);
  EXPECT_LT(least, -2.0);
  EXPECT_LE(most, 5.0);
  EXPECT_GT(most, 4.0);
  EXPECT_NEAR(mean, 1.0, 0.9);
}

TEST(Timers, BeginWithTheirStartAndEndBeforeTheirStop) {
  EXPECT_EQ(sound_of("(timer 0.25 0.5 3)", 7, {}, {.rate = 8}), (std::vector{0.0, 0.0, 3.0, 3.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(sound_of("(combine (timer (vector 0 0.25) 0.5 (vector 1 2)))", 5, {}, {.rate = 8}),
            (std::vector{1.0, 1.0, 3.0, 3.0, 0.0}));
}

TEST(Keyframes, SayWhatIsWrongWithThem) {
  EXPECT_EQ(mistakes_of("(keyframe round 0 1)"), "t.tt:1:1: the interpolation is linear, cubic or hold, not 'round'");
  EXPECT_EQ(mistakes_of("(keyframe linear 0 1 2)"), "t.tt:1:1: a value is missing after the last time");
  EXPECT_EQ(mistakes_of("(keyframe linear 0 1 0 2)"), "t.tt:1:1: times must ascend; 0 comes after 0");
}

}  // namespace idiophone::timbre
