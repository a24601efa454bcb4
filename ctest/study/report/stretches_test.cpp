#include "stretches.hpp"

#include <gtest/gtest.h>

#include "blows.hpp"

namespace idiophone::report {
namespace {

TEST(Stretches, EachBlowHasPartialsOfItsOwn) {
  const std::vector<double> samples = blows({{.start = 0.2, .frequency = 440, .decay_time = 0.4},
                                             {.start = 0.8, .frequency = 1700, .amplitude = 3.0, .decay_time = 0.3},
                                             {.start = 1.5, .frequency = 900, .decay_time = 0.3}},
                                            2.0);
  const std::vector<Impact> impacts = {{.time = 0.2}, {.time = 0.8}, {.time = 1.5}};
  const std::vector<Stretch> found = stretches(samples, rate, impacts);
  ASSERT_EQ(found.size(), 3U);
  const std::vector<double> frequencies = {440.0, 1700.0, 900.0}, decays = {0.4, 0.3, 0.3};
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_FALSE(found[i].partials.found.empty());
    const auto& strongest = *std::ranges::max_element(found[i].partials.found, {}, &partials::Partial::level);
    EXPECT_NEAR(strongest.frequency, frequencies[i], 0.5);
    EXPECT_NEAR(strongest.decay_time.value_or(0.0), decays[i], 0.02);
    EXPECT_GT(found[i].start, impacts[i].time);
  }
  EXPECT_EQ(&loudest(found), &found[1]);
}

TEST(Stretches, BlowsInQuickSuccessionHaveNone) {
  const std::vector<double> samples = blows({{.start = 0.1}, {.start = 0.13}, {.start = 0.16}}, 1.0);
  const auto found = stretches(samples, rate, std::vector<Impact>{{.time = 0.1}, {.time = 0.13}, {.time = 0.16}});
  EXPECT_EQ(found[0].duration, 0.0);
  EXPECT_EQ(found[1].duration, 0.0);
  EXPECT_GT(found[2].duration, 0.8);
}

/// A contact that chatters is one blow; what it leaves behind begins when the bodies part.
TEST(Stretches, TheAnalysisBeginsWhenTheBodiesPart) {
  std::vector<Tone> tones;
  for (double time = 0.1; time < 0.4; time += 0.015) {
    tones.push_back({.start = time, .frequency = 440, .decay_time = 0.8});
  }
  const std::vector<double> samples = blows(tones, 1.5);
  const auto found = stretches(samples, rate, std::vector<Impact>{{.time = 0.1, .cause = "ball", .end = 0.4}});
  EXPECT_GT(found[0].start, 0.4);
  EXPECT_EQ(found[0].partials.found.size(), 1U);
  // A body that comes to rest never parts.
  const auto until_rest = std::span(samples).first(static_cast<std::size_t>(0.3 * rate));
  const auto resting = stretches(until_rest, rate, std::vector<Impact>{{.time = 0.1, .cause = "ball", .end = 0.299}});
  EXPECT_LT(resting[0].start, 0.2);
  EXPECT_GT(resting[0].duration, 0.0);
}

TEST(Stretches, SoundsOfFewSamplesHaveNone) {
  EXPECT_EQ(stretches(std::vector<double>(40, 1.0), rate, std::vector<Impact>{{}})[0].duration, 0.0);
  EXPECT_EQ(stretches({}, rate, std::vector<Impact>{{.time = 2.0}})[0].peak, 0.0);
}

}  // namespace
}  // namespace idiophone::report
