#include "onsets.hpp"

#include <gtest/gtest.h>

#include "blows.hpp"

namespace idiophone::report {
namespace {

void expect_onsets(const std::vector<double>& expected, const std::vector<double>& samples) {
  const std::vector<double> found = onsets(samples, rate);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 0.01);
  }
}

TEST(Onsets, EachBlowOnAnObjectThatStillSounds) {
  expect_onsets({0.0, 0.5, 0.8, 1.6}, blows({{.start = 0.0, .frequency = 440, .decay_time = 8.0},
                                             {.start = 0.5, .frequency = 440, .decay_time = 8.0},
                                             {.start = 0.8, .frequency = 620, .amplitude = 0.3, .decay_time = 2.0},
                                             {.start = 1.6, .frequency = 440, .amplitude = 0.3, .decay_time = 8.0}},
                                            2.5));
}

TEST(Onsets, PartialsThatBeatAreOneBlow) {
  for (const double distance : {2.0, 7.0, 15.0, 40.0}) {
    expect_onsets({0.1}, blows({{.start = 0.1, .frequency = 440, .decay_time = 6.0},
                                {.start = 0.1, .frequency = 440 + distance, .decay_time = 6.0}},
                               2.0));
  }
}

TEST(Onsets, NoneInSilence) {
  expect_onsets({}, std::vector<double>(8000, 0.0));
  expect_onsets({}, {});
}

}  // namespace
}  // namespace idiophone::report
