// Delays to the sample, and recorded sounds.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "measured.hpp"
#include "ranks.hpp"
#include "temporary_sound.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Delays, KeepWavesBetweenSamples) {
  const auto sound = sound_of("(delay (sine 3000) 0.0123456)", 20000);
  for (std::size_t i = 2000; i < sound.size(); ++i) {
    ASSERT_NEAR(sound[i], std::sin(2.0 * std::numbers::pi * 3000.0 * (static_cast<double>(i) / 44100.0 - 0.0123456)),
                1e-4);
  }
  EXPECT_EQ(sound_of("(delay (sine 3000) 0)", 99), sound_of("(sine 3000)", 99));
  EXPECT_NE(mistakes_of("(delay time 2)"), "");
  EXPECT_NE(mistakes_of("(delay time 2 1e9)"), "");
  EXPECT_THROW(static_cast<void>(sound_of("(delay time (- 0.001 time))", 100)), std::runtime_error);
}

TEST(Delays, ThatGrowLowerThePitch) {  // by Doppler's factor 1 - v/c
  const auto sound = sound_of("(delay (sine 1000) (+ 0.01 (* 0.1 time)) 2)", 44100);
  const std::vector<double> end(sound.end() - 22050, sound.end());
  EXPECT_NEAR(std::abs(line(end, 900.0 / 44100.0)), 1.0, 1e-3);
}

TEST(Samples, PlayAtOtherPitchesAndRates) {
  std::vector<double> recorded(22050);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    recorded[i] = std::sin(2.0 * std::numbers::pi * 500.0 * static_cast<double>(i) / 44100.0);
  }
  const support::TemporarySound file(44100, {recorded});
  const std::string quoted = fmt::format("\"{}\"", file.path().string());
  const auto plain = sound_of(fmt::format("(sample {})", quoted), 30000);
  EXPECT_NEAR(plain[1000], recorded[1000], 1e-6);
  EXPECT_EQ(plain.back(), 0.0);
  const auto octave = sound_of(fmt::format("(sample {} 2)", quoted), 8820);
  EXPECT_NEAR(std::abs(line(octave, 1000.0 / 44100.0)), 1.0, 0.01);
  const auto resampled = sound_of(fmt::format("(sample {})", quoted), 8000, {}, {.rate = 22050});
  EXPECT_NEAR(std::abs(line(resampled, 500.0 / 22050.0)), 1.0, 0.01);
  EXPECT_NE(mistakes_of("(sample \"nothing.wav\")"), "");
  EXPECT_EQ(mistakes_of(fmt::format("(sample {} -1)", quoted)),
            "t.tt:1:1: the pitch of a sample is from 0 to 64, not -1");
}

TEST(Delays, OfWholeSamplesKeepEveryBit) {
  const auto expect_delayed = [&](const std::string& tree, std::size_t samples, int rate) {
    const auto plain = sound_of("white", 5000, {}, {.rate = rate});
    const auto sound = sound_of(tree, 5000, {}, {.rate = rate});
    for (std::size_t i = 0; i < sound.size(); ++i) {
      ASSERT_EQ(sound[i], i < samples ? 0.0 : plain[i - samples]) << tree << " " << i;
    }
  };
  expect_delayed("(delay white 0.01)", 441, 44100);
  expect_delayed("(delay white 0.01 0.01)", 441, 44100);  // the ring is as short as it can be
  expect_delayed("(delay white 0.001)", 8, 8000);         // shorter than the interpolation reaches
}

TEST(Delays, OfPartsOfASampleAreALinearPhaseAndAGainOfOne) {
  const auto sound = sound_of(fmt::format("(delay {} (/ 100.37 44100))", impulse), 300);
  for (const double frequency : {0.0, 0.1, 0.2, 0.4}) {
    const std::complex<double> expected = std::polar(1.0, -2.0 * std::numbers::pi * frequency * 100.37);
    EXPECT_LT(std::abs(response(sound, frequency) - expected), 4e-3) << frequency;
  }
}

TEST(Delays, HavePossibleTimes) {
  EXPECT_EQ(mistakes_of("(delay time 2)"),
            "t.tt:1:1: a delay of 2 s is not possible: it must be 0, or from 0.00036 s to the longest delay, 1 s");
  EXPECT_EQ(mistakes_of("(delay time 0.0001)"),
            "t.tt:1:1: a delay of 0.0001 s is not possible: it must be 0, or from 0.00036 s to the longest delay, 1 s");
  EXPECT_EQ(mistakes_of("(combine (delay time (vector 0.5 -0.5)))"),
            "t.tt:1:10: a delay of -0.5 s is not possible: it must be 0, or from 0.00036 s to the longest delay, 1 s");
  EXPECT_EQ(mistakes_of("(delay time 1 61)"), "t.tt:1:1: the longest delay must be above 0 and at most 60 s");
  EXPECT_EQ(mistakes_of("(reverberate time 0)"), "t.tt:1:1: the decay time must be above 0 and at most 100 s");
}

TEST(Delays, OfEachComponentAreItsOwn) {
  EXPECT_EQ(sound_of("(combine (delay (vector 1 10) (vector 0 0.01)) (vector 1 1))", 442).at(440), 1.0);
  EXPECT_EQ(sound_of("(combine (delay (vector 1 10) (vector 0 0.01)) (vector 1 1))", 442).at(441), 11.0);
}

TEST(Samples, AreReadOnceToTheEndAtEveryPitch) {
  const support::TemporarySound file(44100, {{0.5, 0.25, -0.5, -0.25}});
  const std::string quoted = fmt::format("\"{}\"", file.path().string());
  EXPECT_EQ(sound_of(fmt::format("(sample {})", quoted), 6), (std::vector{0.5, 0.25, -0.5, -0.25, 0.0, 0.0}));
  const auto stopped = sound_of(fmt::format("(sample {} 0)", quoted), 100);  // stays where it is
  EXPECT_NEAR(stopped.front(), 0.5, 1e-12);
  EXPECT_EQ(stopped.back(), stopped.front());
  EXPECT_EQ(sound_of(fmt::format("(sample {} 64)", quoted), 2).back(), 0.0);
}

TEST(Samples, FeedConvolutions) {
  const support::TemporarySound file(44100, {{0.5, 0.25, -0.5}});
  EXPECT_EQ(sound_of(fmt::format("(convolve {} \"{}\")", impulse, file.path().string()), 5),
            (std::vector{0.5, 0.25, -0.5, 0.0, 0.0}));
  EXPECT_NE(mistakes_of("(convolve 1 \"nothing.wav\")"), "");
}

}  // namespace idiophone::timbre
