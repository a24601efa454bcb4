// Recorded sounds: loops, beginnings and grains.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measured.hpp"
#include "ranks.hpp"
#include "temporary_sound.hpp"

namespace idiophone::timbre {

namespace {

std::string quoted(const support::TemporarySound& file) {
  return fmt::format("\"{}\"", file.path().string());
}

/// A second of a sine whose frequency rises from 400 Hz to 1200 Hz.
std::vector<double> rising_sine() {
  std::vector<double> sound(44100);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const double time = static_cast<double>(i) / 44100.0;
    sound[i] = 0.5 * static_cast<double>(
                         static_cast<float>(std::sin(2.0 * std::numbers::pi * (400.0 * time + 400.0 * time * time))));
  }
  return sound;
}

/// Frequency by counting how often the sign changes.
double frequency_of(const std::vector<double>& sound, std::size_t begin, std::size_t end) {
  int changes = 0;
  for (std::size_t i = begin + 1; i < end; ++i) {
    changes += (sound[i] > 0.0) != (sound[i - 1] > 0.0) ? 1 : 0;
  }
  return 0.5 * changes * 44100.0 / static_cast<double>(end - begin);
}

}  // namespace

ON_RANKS(1);

TEST(Recordings, BeginAnywhereAndRepeat) {
  const support::TemporarySound file(1000, {{0.5, 0.25, -0.5, -0.25}});
  const auto played = [&](const char* arguments) {
    return sound_of(fmt::format("(sample {} {})", quoted(file), arguments), 7, {}, {.rate = 1000});
  };
  EXPECT_EQ(played("1 0.002"), (std::vector{-0.5, -0.25, 0.0, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(played("1 0 1"), (std::vector{0.5, 0.25, -0.5, -0.25, 0.5, 0.25, -0.5}));
  EXPECT_EQ(played("1 0.001 1"), (std::vector{0.25, -0.5, -0.25, 0.25, -0.5, -0.25, 0.25}));
}

TEST(Recordings, RepeatAtEveryPitchWithoutASeam) {  // a whole number of cycles
  std::vector<double> cycles(441);
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    cycles[i] = std::sin(2.0 * std::numbers::pi * 10.0 * static_cast<double>(i) / 441.0);
  }
  const support::TemporarySound file(44100, {cycles});
  const auto sound = sound_of(fmt::format("(sample {} 0.7321 0 1)", quoted(file)), 4000);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * 10.0 * 0.7321 * static_cast<double>(i) / 441.0;
    ASSERT_NEAR(sound[i], std::sin(angle), 2e-3) << i;
  }
}

TEST(Recordings, EndTheirSoundUnlessTheyRepeat) {
  const support::TemporarySound file(8000, {std::vector<double>(4000, 0.5)});  // 0.5 s
  const auto ends_within = [&](const char* arguments, int samples) {
    Graph graph(parse_tree(fmt::format("(sample {} {})", quoted(file), arguments), "t.tt"), {}, {.rate = 8000});
    std::vector<double> sound(samples);
    graph.render(sound);
    graph.render(std::span(sound).first(64));
    return graph.has_ended();
  };
  EXPECT_FALSE(ends_within("1", 3800));
  EXPECT_TRUE(ends_within("1", 4100));
  EXPECT_TRUE(ends_within("2", 2100));
  EXPECT_FALSE(ends_within("1 0 1", 40000));
}

TEST(Recordings, HavePossibleArguments) {
  const support::TemporarySound file(44100, {std::vector<double>(4410, 0.5)});
  EXPECT_EQ(mistakes_of(fmt::format("(sample {} 1 0.2)", quoted(file))),
            fmt::format("t.tt:1:1: the start is from 0 to the end of {}, 0.1 s, not 0.2", file.path().string()));
  EXPECT_EQ(mistakes_of(fmt::format("(sample {} 1 0 2)", quoted(file))), "t.tt:1:1: loop is 0 or 1, not 2");
  EXPECT_EQ(mistakes_of(fmt::format("(grains {} time 1 0)", quoted(file))),
            "t.tt:1:1: the density is from 0.1 to 1000 grains in a second, not 0");
}

TEST(Grains, ThatFollowTheTimeAreTheRecording) {
  const support::TemporarySound file(44100, {rising_sine()});
  const auto whole = rising_sine();
  const auto sound = sound_of(fmt::format("(grains {} time 1 50 0.08)", quoted(file)), 40000);
  for (std::size_t i = 3528; i < sound.size(); ++i) {  // once four grains sound
    ASSERT_NEAR(sound[i], whole[i], 1e-3) << i;
  }
}

TEST(Grains, StayAtAPlaceOfTheRecordingAndChangeItsPitch) {
  const support::TemporarySound file(44100, {rising_sine()});
  const auto frequency = [&](const char* arguments) {
    return frequency_of(sound_of(fmt::format("(grains {} {})", quoted(file), arguments), 88200), 8820, 88200);
  };
  EXPECT_NEAR(frequency("0.46"), 400.0 + 800.0 * 0.5, 40.0);  // the middle of a grain is 0.04 s later
  EXPECT_NEAR(frequency("(+ 0.42 (* 0 time)) 2"), 2.0 * 800.0, 80.0);
  EXPECT_NEAR(frequency("10.46"), 800.0, 40.0);  // the recording repeats
  EXPECT_NEAR(frequency("-0.54"), 800.0, 40.0);
}

TEST(Grains, SpreadByChanceThatDependsOnTheSeed) {
  const support::TemporarySound file(44100, {rising_sine()});
  const auto sound = [&](int seed) {
    return sound_of(fmt::format("(grains {} 0.3 1 50 0.08 0.2 {})", quoted(file), seed), 8820);
  };
  EXPECT_EQ(sound(1), sound(1));
  EXPECT_NE(sound(1), sound(2));
}

}  // namespace idiophone::timbre
