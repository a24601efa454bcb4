#include "notation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "ranks.hpp"

namespace idiophone::timbre {

namespace {

ScorePart in_scale(const std::string& name, int tonic) {
  const auto& scales = musical_scales();
  const auto found = std::ranges::find(scales, name, &std::pair<std::string, std::vector<int>>::first);
  return {.name = "a", .tonic = tonic, .scale = static_cast<std::size_t>(found - scales.begin())};
}

/// Lengths, negative for rests.
std::vector<int> lengths(const std::vector<Symbol>& measure) {
  std::vector<int> all;
  for (const Symbol& symbol : measure) {
    all.push_back(symbol.note == nullptr ? -symbol.length : symbol.length);
  }
  return all;
}

std::string name_of(int number, int fifths) {
  const Spelling spelling = spelling_of(number, fifths);
  return spelling.step + std::string(std::max(spelling.alter, 0), '#') +
         std::string(std::max(-spelling.alter, 0), 'b') + std::to_string(spelling.octave);
}

}  // namespace

ON_RANKS(1);

TEST(Notation, ChoosesNoteValuesNearAModerateTempo) {
  EXPECT_EQ(tempo_of(0.5).step, 8);
  EXPECT_DOUBLE_EQ(tempo_of(0.5).quarters_per_minute, 120.0);
  EXPECT_EQ(tempo_of(0.25).step, 4);
  EXPECT_DOUBLE_EQ(tempo_of(0.3).quarters_per_minute, 100.0);  // an eighth
  EXPECT_EQ(tempo_of(0.01).step, 1);
  EXPECT_EQ(tempo_of(60.0).step, 32);
}

TEST(Notation, FillsMeasuresWithNotesAndRestsAndTiesOverBars) {
  ScorePart part = in_scale("ionian", 60);
  part.notes = {{.start = 1, .length = 5, .number = 60}, {.start = 7, .length = 9, .number = 62}};
  const auto measures = measures_of(part, 8, 17);  // quarters
  ASSERT_EQ(measures.size(), 5U);
  EXPECT_EQ(lengths(measures[0]), (std::vector{-8, 24}));
  EXPECT_EQ(lengths(measures[1]), (std::vector{16, -8, 8}));
  EXPECT_EQ(lengths(measures[2]), (std::vector{32}));
  EXPECT_EQ(lengths(measures[3]), (std::vector{32}));
  EXPECT_EQ(lengths(measures[4]), (std::vector{-32}));
  EXPECT_TRUE(measures[0][1].goes_on && measures[1][0].continues);
  EXPECT_FALSE(measures[0][1].continues || measures[1][0].goes_on);
  EXPECT_TRUE(measures[2][0].continues && measures[2][0].goes_on);
  EXPECT_FALSE(measures[3][0].goes_on);
}

TEST(Notation, DividesLengthsThatNoSymbolHas) {
  ScorePart part = in_scale("ionian", 60);
  part.notes = {{.start = 0, .length = 5, .number = 60}, {.start = 6, .length = 7, .number = 60}};
  const auto measures = measures_of(part, 1, 13);
  ASSERT_EQ(measures.size(), 1U);
  EXPECT_EQ(lengths(measures[0]), (std::vector{4, 1, -1, 7, -16, -3}));
  EXPECT_TRUE(measures[0][0].goes_on && measures[0][1].continues);
  EXPECT_EQ(std::accumulate(measures[0].begin(), measures[0].end(), 0,
                            [](int sum, const Symbol& symbol) { return sum + symbol.length; }),
            length_of_measure);
  EXPECT_EQ(lengths(measures_of(in_scale("blues", 60), 8, 0)[0]), (std::vector{-32}));
}

TEST(Notation, HasTheKeyOfTheScale) {
  EXPECT_EQ(fifths_of(in_scale("ionian", 60)), 0);
  EXPECT_EQ(fifths_of(in_scale("aeolian", 57)), 0);
  EXPECT_EQ(fifths_of(in_scale("dorian", 62)), 0);
  EXPECT_EQ(fifths_of(in_scale("phrygian", 52)), 0);
  EXPECT_EQ(fifths_of(in_scale("lydian", 53)), 0);
  EXPECT_EQ(fifths_of(in_scale("mixolydian", 67)), 0);
  EXPECT_EQ(fifths_of(in_scale("locrian", 59)), 0);
  EXPECT_EQ(fifths_of(in_scale("ionian", 64)), 4);   // E: four sharps
  EXPECT_EQ(fifths_of(in_scale("ionian", 61)), -5);  // D flat: five flats
  EXPECT_EQ(fifths_of(in_scale("blues", 48)), -3);
  EXPECT_EQ(fifths_of(in_scale("chromatic", 64)), 0);
}

TEST(Notation, NamesNotes) {
  EXPECT_EQ(name_of(60, 0), "C4");
  EXPECT_EQ(name_of(66, 0), "F#4");
  EXPECT_EQ(name_of(70, 0), "Bb4");
  EXPECT_EQ(name_of(66, -3), "Gb4");  // the blue note on c
  EXPECT_EQ(name_of(60, 6), "B#3");
  EXPECT_EQ(name_of(59, -5), "Cb4");
  EXPECT_EQ(name_of(0, 0), "C-1");
  for (int fifths = -5; fifths <= 6; ++fifths) {  // every name has the number that it came from
    for (int number = 0; number < 128; ++number) {
      const Spelling spelling = spelling_of(number, fifths);
      const auto natural = static_cast<int>(std::string("C D EF G A B").find(spelling.step));
      EXPECT_EQ(12 * (spelling.octave + 1) + natural + spelling.alter, number);
      EXPECT_LE(std::abs(spelling.alter), 2);
    }
  }
}

}  // namespace idiophone::timbre
