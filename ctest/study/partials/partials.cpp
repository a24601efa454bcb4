#include "idiophone/study/partials/partials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sounds.hpp"

namespace idiophone::partials {
namespace {

/// Of a sound that is a sum of damped sines and noise.
std::vector<Partial> partials_of(const std::vector<double>& samples, double samples_per_second,
                                 const PartialOptions& options = {}) {
  const Partials partials = find_partials(samples, samples_per_second, options);
  EXPECT_TRUE(partials.complete);
  return partials.found;
}

/// How far partials may be off what was planted.
struct Allowance {
  double level = 0.1;   // dB
  double decay = 0.02;  // of the decay time
};

/// Expects exactly the planted partials (by ascending frequency), each to 0.1 Hz or 1 cent.
void expect_exactly(const std::vector<Planted>& planted, const std::vector<Partial>& found, Allowance allowance = {}) {
  ASSERT_EQ(found.size(), planted.size());
  for (std::size_t j = 0; j < planted.size(); ++j) {
    const double cent = planted[j].frequency * (std::exp2(1.0 / 1200.0) - 1.0);
    EXPECT_NEAR(found[j].frequency, planted[j].frequency, std::max(0.1, cent));
    EXPECT_NEAR(found[j].level, 20.0 * std::log10(planted[j].amplitude), allowance.level) << found[j].frequency;
    ASSERT_TRUE(found[j].decay_time.has_value()) << found[j].frequency;
    EXPECT_NEAR(*found[j].decay_time / planted[j].decay_time, 1.0, allowance.decay) << found[j].frequency;
  }
}

void plant_and_expect(const std::vector<Planted>& planted, double duration, Disturbance disturbance = {},
                      Allowance allowance = {}) {
  expect_exactly(planted, partials_of(sound(planted, duration, disturbance), rate), allowance);
}

TEST(Partials, OnePartialIsFoundToRounding) {
  const std::vector<Planted> planted = {{.frequency = 440.0, .amplitude = 0.5, .decay_time = 1.5}};
  const auto found = partials_of(sound(planted, 1.0), rate);
  ASSERT_EQ(found.size(), 1);
  EXPECT_NEAR(found[0].frequency, 440.0, 1e-8);
  EXPECT_NEAR(found[0].level, -6.0206, 1e-4);
  ASSERT_TRUE(found[0].decay_time.has_value());
  EXPECT_NEAR(*found[0].decay_time, 1.5, 1e-8);
}

TEST(Partials, AnUndampedOneHasNoDecayTime) {
  const std::vector<Planted> planted = {{.frequency = 440.0, .decay_time = 1e9}};
  const auto found = partials_of(sound(planted, 1.0, {.noise = 0.01}), rate);
  ASSERT_EQ(found.size(), 1);
  EXPECT_FALSE(found[0].decay_time.has_value());
}

TEST(Partials, ThreeHertzApart) {
  const std::vector<Planted> planted = {{.frequency = 440.0},
                                        {.frequency = 443.0, .amplitude = 0.5, .decay_time = 0.7, .phase = 2.0}};
  plant_and_expect(planted, 1.0);
  plant_and_expect(planted, 1.0, {.noise = 0.01});
}

TEST(Partials, HalfAHertzAndFortyDecibelsApartInSoundsOfAnyLength) {
  for (const double decay : {3.0, 10.0}) {
    const std::vector<Planted> planted = {{.frequency = 440.0, .decay_time = decay},
                                          {.frequency = 440.5, .amplitude = 0.01, .decay_time = decay, .phase = 2.0}};
    for (const double duration : {2.0, 6.0}) {
      SCOPED_TRACE(testing::Message() << "T60 " << decay << " s, sound " << duration << " s");
      plant_and_expect(planted, duration);
    }
  }
}

TEST(Partials, WhatCannotBeSeparatedIsReported) {
  const std::vector<Planted> alone = {{.frequency = 440.0}};
  EXPECT_FALSE(partials_of(sound(alone, 1.0, {.noise = 0.001}), rate).at(0).remainder);
  // Nearer than the least distance.
  const std::vector<Planted> pair = {{.frequency = 440.0}, {.frequency = 440.4, .amplitude = 0.5, .phase = 2.0}};
  const auto merged = partials_of(sound(pair, 2.0), rate, {.separation = 2.0});
  ASSERT_EQ(merged.size(), 1);
  ASSERT_TRUE(merged[0].remainder);
  EXPECT_GT(*merged[0].remainder, -60.0);
}

TEST(Partials, TwoPerMilleApart) {
  for (const double lower : {500.0, 1000.0, 4000.0}) {
    const std::vector<Planted> planted = {
        {.frequency = lower}, {.frequency = 1.002 * lower, .amplitude = 0.8, .decay_time = 1.3, .phase = 2.0}};
    plant_and_expect(planted, 1.0);
    plant_and_expect(planted, 1.0, {.noise = 0.001});
  }
}

TEST(Partials, VeryDifferentDecays) {
  const std::vector<Planted> planted = {{.frequency = 200.0, .decay_time = 5.0},
                                        {.frequency = 400.0, .decay_time = 0.1},
                                        {.frequency = 900.0, .amplitude = 0.1, .decay_time = 2.0},
                                        {.frequency = 1500.0, .decay_time = 0.03},
                                        {.frequency = 3000.0, .amplitude = 0.01, .decay_time = 10.0}};
  plant_and_expect(planted, 1.0);
  plant_and_expect(planted, 1.0, {.noise = 0.01}, {.level = 0.2, .decay = 0.1});
}

TEST(Partials, UnderAThumpAndAnOffset) {
  const std::vector<Planted> planted = {{.frequency = 200.0},
                                        {.frequency = 260.0, .amplitude = 0.1, .decay_time = 0.5}};
  plant_and_expect(planted, 1.0, {.noise = 0.0, .constant = 3.0, .thump = 10.0});
  plant_and_expect(planted, 1.0, {.noise = 0.001, .constant = 3.0, .thump = 10.0});
}

// A blow pushes a free body, mass damping brakes it, and the emitter blocks constants: two decays without oscillation.
TEST(Partials, OverTwoSlowDecays) {
  const std::vector<Planted> planted = {{.frequency = 574.0, .decay_time = 2.2},
                                        {.frequency = 1570.0, .amplitude = 2.0, .decay_time = 1.9}};
  for (const double duration : {0.3, 0.48}) {
    for (const double second : {-0.05, -0.1, -0.3, 0.5}) {
      for (const double push : {1.7, 5.9}) {
        SCOPED_TRACE(testing::Message() << duration << " s, amplitudes " << push << " and " << second * push);
        std::vector<Planted> with_decays = planted;
        with_decays.push_back({.frequency = 0.0, .amplitude = push, .decay_time = 0.11, .phase = 0.0});
        with_decays.push_back({.frequency = 0.0, .amplitude = second * push, .decay_time = 0.6, .phase = 0.0});
        expect_exactly(planted, partials_of(sound(with_decays, duration), rate), {.level = 0.01, .decay = 0.002});
      }
    }
  }
}

TEST(Partials, HalfASecond) {
  plant_and_expect({{.frequency = 100.0},
                    {.frequency = 220.0, .amplitude = 0.3, .decay_time = 0.5},
                    {.frequency = 226.0, .amplitude = 0.3, .decay_time = 0.6}},
                   0.5);
}

TEST(Partials, OverlappingBroadLines) {
  const std::vector<Planted> planted = {{.frequency = 500.0, .decay_time = 0.1},  // 22 Hz wide at half power
                                        {.frequency = 550.0, .amplitude = 0.7, .decay_time = 0.12, .phase = 1.0},
                                        {.frequency = 590.0, .decay_time = 0.08, .phase = 2.0}};
  plant_and_expect(planted, 1.0);
  plant_and_expect(planted, 1.0, {.noise = 0.01}, {.level = 0.3, .decay = 0.03});
}

TEST(Partials, AtBothEndsOfTheRange) {
  const std::vector<Planted> planted = {{.frequency = 20.5, .decay_time = 2.0},
                                        {.frequency = 25.0, .amplitude = 0.5},
                                        {.frequency = 22000.0, .decay_time = 0.5},
                                        {.frequency = 22030.0, .amplitude = 0.3}};
  plant_and_expect(planted, 1.0);
  plant_and_expect(planted, 1.0, {.noise = 0.01, .constant = 1.0, .thump = 1.0});
}

TEST(Partials, FortyOfThem) {
  std::vector<Planted> planted;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform;
  for (double frequency = 100.0; planted.size() < 40; frequency += 5.0 + 200.0 * uniform(generator)) {
    planted.push_back({.frequency = frequency,
                       .amplitude = std::pow(10.0, -2.0 * uniform(generator)),
                       .decay_time = 0.2 + 2.0 * uniform(generator),
                       .phase = 6.0 * uniform(generator)});
  }
  plant_and_expect(planted, 1.0);
  plant_and_expect(planted, 1.0, {.noise = 0.001}, {.level = 0.5, .decay = 0.1});
}

// Two lines that begin on either side of one peak come to lie on each other when their neighbours are known better.
// Where both stayed, neither was determined, and a strong partial was missing in some of these sounds.
TEST(Partials, TenInSixtyMilliseconds) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(testing::Message() << "sound " << trial);
    std::vector<Planted> planted;
    for (double frequency = 100.0 + 300.0 * uniform(generator); planted.size() < 10;
         frequency *= 1.1 + 0.6 * uniform(generator)) {
      planted.push_back({.frequency = frequency,
                         .amplitude = std::pow(10.0, -1.5 * uniform(generator)),
                         .decay_time = 30.0 / std::sqrt(frequency) * (0.5 + uniform(generator)),
                         .phase = 6.0 * uniform(generator)});
    }
    const auto found = partials_of(sound(planted, 0.06, {.noise = 1e-4}), rate, {.dynamic_range = 60.0});
    expect_exactly(planted, found, {.level = 0.5, .decay = 0.1});
  }
}

TEST(Partials, NothingIsInvented) {
  EXPECT_TRUE(partials_of(sound({}, 1.0), rate).empty()) << "silence";
  EXPECT_TRUE(partials_of(sound({}, 1.0, {.noise = 1.0}), rate).empty()) << "white noise";
  EXPECT_TRUE(partials_of(sound({}, 0.3, {.noise = 1e-6}), rate).empty()) << "short white noise";
  EXPECT_TRUE(partials_of(sound({}, 1.0, {.noise = 0.0, .constant = 1.0, .thump = 5.0}), rate).empty()) << "thump";
}

TEST(Partials, BrownNoiseHasAlmostNone) {
  auto samples = sound({}, 1.0, {.noise = 1.0});
  for (std::size_t n = 1; n < samples.size(); ++n) {
    samples[n] += 0.999 * samples[n - 1];
  }
  EXPECT_LE(partials_of(samples, rate).size(), 1);
}

TEST(Partials, TheSearchEndsEarlyInASoundWithAClick) {
  auto samples = sound(std::vector<Planted>{{.frequency = 440.0}}, 0.5);
  samples[1000] += 10.0;
  EXPECT_FALSE(find_partials(samples, rate).complete);
}

TEST(Partials, ANotQuiteExponentialDecayIsStillOnePartial) {
  auto samples = sound(std::vector<Planted>{{.frequency = 440.0}}, 1.0);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double t = static_cast<double>(n) / rate;
    samples[n] *= std::exp(-0.3 * t * t);
  }
  EXPECT_EQ(partials_of(samples, rate).size(), 1);
}

TEST(Partials, LevelsAreThoseAtTheStart) {
  // A blow of 1 ms before the sound is free.
  const std::vector<Planted> planted = {{.frequency = 300.0},
                                        {.frequency = 800.0, .amplitude = 0.3, .decay_time = 0.4}};
  auto samples = sound(planted, 1.0);
  for (std::size_t n = 0; n < 44; ++n) {
    samples[n] += 20.0;
  }
  auto expected = planted;
  for (Planted& partial : expected) {
    partial.amplitude *= std::pow(10.0, -3.0 * 0.01 / partial.decay_time);
  }
  expect_exactly(expected, partials_of(samples, rate, {.start = 0.01}), {.level = 0.01, .decay = 0.001});
}

TEST(Partials, OptionsSayWhatIsLookedFor) {
  const std::vector<Planted> planted = {
      {.frequency = 300.0}, {.frequency = 800.0, .amplitude = 0.1}, {.frequency = 2000.0, .amplitude = 0.001}};
  const auto samples = sound(planted, 1.0);
  EXPECT_EQ(partials_of(samples, rate).size(), 3);
  EXPECT_EQ(partials_of(samples, rate, {.lowest = 500.0}).size(), 2);
  EXPECT_EQ(partials_of(samples, rate, {.highest = 1000.0}).size(), 2);
  EXPECT_EQ(partials_of(samples, rate, {.dynamic_range = 40.0}).size(), 2);
  EXPECT_EQ(partials_of(samples, rate, {.most = 1}).size(), 1);
  EXPECT_EQ(partials_of(samples, rate, {.duration = 0.2}).size(), 3);
}

TEST(Partials, TheDeviationIsThatOfTheFit) {
  const std::vector<Planted> planted = {{.frequency = 440.0}};
  const auto found = partials_of(sound(planted, 1.0, {.noise = 0.1}), rate);
  ASSERT_EQ(found.size(), 1);
  EXPECT_LT(std::abs(found[0].frequency - 440.0), 4.0 * found[0].frequency_deviation);
  EXPECT_LT(found[0].frequency_deviation, 0.02);
}

TEST(Partials, WrongInputIsRefused) {
  auto samples = sound(std::vector<Planted>{{.frequency = 440.0}}, 0.1);
  EXPECT_THROW((void)partials_of(samples, 0.0), std::invalid_argument);
  EXPECT_THROW((void)partials_of({}, rate), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.start = 0.2}), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.start = 0.0999}), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.duration = 1.0}), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.lowest = 500.0, .highest = 400.0}), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.highest = 30000.0}), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.dynamic_range = 0.0}), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.prominence = 1.0}), std::invalid_argument);
  EXPECT_THROW((void)partials_of(samples, rate, {.separation = -1.0}), std::invalid_argument);
  samples[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)partials_of(samples, rate), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::partials
