#include "recurring_partials.hpp"

#include <gtest/gtest.h>

#include "blows.hpp"

namespace idiophone::report {
namespace {

/// A ball that bounces on a body of three modes, at last faster than blows can be told apart.
struct Bouncing {
  std::vector<Tone> tones;
  std::vector<Impact> impacts;
};

Bouncing bounces(std::size_t count) {
  Bouncing bouncing;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(0.3, 1.0);
  double time = 0.1, wait = 0.6, strength = 1.0;
  for (std::size_t n = 0; n < count; ++n, time += wait, wait *= 0.85, strength *= 0.85) {
    for (const auto& [frequency, decay_time] : {std::pair{440.0, 1.5}, {1210.0, 0.9}, {2370.0, 0.5}}) {
      bouncing.tones.push_back({time, frequency, strength * part(random), decay_time});
    }
    bouncing.impacts.push_back({.time = time, .cause = "ball", .end = time + 0.001});
  }
  return bouncing;
}

TEST(RecurringPartials, ThreeModesOfABodyThatIsStruckOftenAreThreePartials) {
  const auto [tones, impacts] = bounces(16);
  const std::vector<Stretch> found = stretches(blows(tones, 4.5), rate, impacts);
  std::size_t single = 0;
  for (const Stretch& stretch : found) {
    single += stretch.partials.found.size();
  }
  const auto recurring = recurring_partials(found);
  EXPECT_GT(single, 30U);
  ASSERT_EQ(recurring.size(), 3U);
  const std::vector<double> frequencies = {440.0, 1210.0, 2370.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(recurring[i].loudest.frequency, frequencies[i], 0.5);
    EXPECT_GT(recurring[i].impacts, 8U);
  }
}

/// A search that ended early finds many lines of the blow that nobody found.
TEST(RecurringPartials, ASearchThatEndedEarlyCountsOnlyIfAllDid) {
  Stretch complete{.start = 0.1, .duration = 0.5};
  complete.partials.found = {{.frequency = 440.0, .level = -20.0}};
  Stretch early = complete;
  early.partials = {.found = {{.frequency = 440.1, .level = -10.0}, {.frequency = 447.0, .level = -12.0}},
                    .complete = false};
  EXPECT_EQ(recurring_partials(std::vector<Stretch>{complete, early}).size(), 1U);
  EXPECT_EQ(recurring_partials(std::vector<Stretch>{early}).size(), 2U);
}

TEST(RecurringPartials, WhatOnlyOneBlowExcitesStays) {
  const std::vector<double> samples = blows({{.start = 0.2, .frequency = 440, .decay_time = 0.3},
                                             {.start = 0.8, .frequency = 1700, .decay_time = 0.3},
                                             {.start = 1.5, .frequency = 440, .decay_time = 0.3}},
                                            2.0);
  const std::vector<Impact> impacts = {{.time = 0.2}, {.time = 0.8}, {.time = 1.5}};
  const auto recurring = recurring_partials(stretches(samples, rate, impacts));
  ASSERT_EQ(recurring.size(), 2U);
  EXPECT_EQ(recurring[0].impacts, 2U);
  EXPECT_EQ(recurring[1].impacts, 1U);
}

TEST(RecurringPartials, NoneInSilence) {
  EXPECT_TRUE(recurring_partials(stretches(std::vector<double>(8000, 0.0), rate, std::vector<Impact>{{}})).empty());
}

}  // namespace
}  // namespace idiophone::report
