#include "idiophone/study/fitting/target.hpp"

#include <gmock/gmock.h>

#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

ON_RANKS(1);

TEST(Target, NotesOfEqualTemperament) {
  EXPECT_DOUBLE_EQ(note_frequency("A4"), 440);
  EXPECT_NEAR(note_frequency("F#3"), 184.997, 1e-3);
  EXPECT_NEAR(note_frequency("C4"), 261.626, 1e-3);
  EXPECT_DOUBLE_EQ(note_frequency("Bb3"), note_frequency("a#3"));
  EXPECT_DOUBLE_EQ(note_frequency("A3", 442), 221);
  for (const char* wrong : {"H4", "A", "A#", "4", "A44", ""}) {
    EXPECT_THROW(static_cast<void>(note_frequency(wrong)), std::runtime_error) << wrong;
  }
}

TEST(Target, FrequenciesNotesAndRatios) {
  const Target mixed = read_target("187,A4", {}, 440);
  EXPECT_FALSE(mixed.are_ratios);
  EXPECT_THAT(mixed.values, ElementsAre(187, DoubleNear(440, 1e-9)));
  const Target ratios = read_target("1:4:10", {}, 440);
  EXPECT_TRUE(ratios.are_ratios);
  EXPECT_THAT(ratios.values, ElementsAre(1, 4, 10));
  const Target pitched = read_target("2:8:20", "187", 440);
  EXPECT_FALSE(pitched.are_ratios);
  EXPECT_THAT(pitched.values, ElementsAre(187, 748, 1870));
}

TEST(Target, RefusesOtherTexts) {
  for (const char* wrong : {"", "1:-4", "1:x", "187,zebra", "1:", "0"}) {
    EXPECT_THROW(static_cast<void>(read_target(wrong, {}, 440)), std::runtime_error) << wrong;
  }
  EXPECT_THROW(static_cast<void>(read_target("187", "F#3", 440)), std::runtime_error);
}

TEST(Target, Levels) {
  const WantedLevel equal = read_wanted_level("ears.left=70.5");
  EXPECT_EQ(equal.listener, "ears.left");
  EXPECT_EQ(equal.kind, WantedLevel::Kind::equal);
  EXPECT_EQ(equal.level, 70.5);
  EXPECT_EQ(read_wanted_level("ear=at_least:70").kind, WantedLevel::Kind::at_least);
  EXPECT_EQ(read_wanted_level("ear=at_most:-3").kind, WantedLevel::Kind::at_most);
  EXPECT_EQ(read_wanted_level("ear=at_most:-3").level, -3);
  for (const char* wrong : {"", "ear", "ear=", "=70", "ear=loud", "ear=at_least:", "ear=below:70", "ear=70=71"}) {
    EXPECT_THROW(static_cast<void>(read_wanted_level(wrong)), std::runtime_error) << wrong;
  }
}

TEST(Target, DecayTimesAndBands) {
  const WantedDecay decay = read_wanted_decay("3=2.5");
  EXPECT_EQ(decay.mode, 3);
  EXPECT_EQ(decay.decay_time, 2.5);
  const Band band = read_band("380:A4", 440);
  EXPECT_EQ(band.lower, 380);
  EXPECT_NEAR(band.upper, 440, 1e-9);
  const Band around = read_band("A4~1200", 440);
  EXPECT_NEAR(around.lower, 220, 1e-9);
  EXPECT_NEAR(around.upper, 880, 1e-9);
  for (const char* wrong : {"", "3", "3=", "3=0", "1.5=2", "0=2", "x=2", "3=2=1", "1e9=2"}) {
    EXPECT_THROW(static_cast<void>(read_wanted_decay(wrong)), std::runtime_error) << wrong;
  }
  for (const char* wrong : {"", "380", "420:380", "380:380", "380:420:430", "A4~0", "A4~-3", "A4~3000", "H4~30"}) {
    EXPECT_THROW(static_cast<void>(read_band(wrong, 440)), std::runtime_error) << wrong;
  }
}

}  // namespace
}  // namespace idiophone::fitting
