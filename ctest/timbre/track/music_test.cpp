#include "music.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "ranks.hpp"
#include "recorded_motion.hpp"

namespace idiophone::timbre {

namespace {

/// A part whose notes follow the ball's velocity along x, 0 to 1 m/s in a second.
MusicPart rising(int octaves) {
  const auto& scales = musical_scales();
  const auto ionian = std::ranges::find(scales, "ionian", &std::pair<std::string, std::vector<int>>::first);
  return {.name = "a",
          .pitch = {.channel = "motion/ball/velocity", .column = "x", .where = {}},
          .from = {0.0, 1.0},
          .scale = static_cast<std::size_t>(ionian - scales.begin()),
          .tonic = 60,
          .octaves = octaves};
}

}  // namespace

ON_RANKS(1);

TEST(Music, MapsARangeToAScale) {
  timbre::MusicPart part{
      .name = "a", .pitch = {}, .from = {-1.0, 1.0}, .scale = 8, .tonic = 48, .octaves = 1};  // blues
  ASSERT_EQ(timbre::musical_scales()[part.scale].first, "blues");
  std::vector<int> notes;
  for (int step = 0; step <= 6; ++step) {
    notes.push_back(note_of(part, -1.0 + step / 3.0));
  }
  EXPECT_EQ(notes, (std::vector{48, 51, 53, 54, 55, 58, 60}));
  EXPECT_EQ(note_of(part, -9.0), 48);
  EXPECT_EQ(note_of(part, 9.0), 60);
}

TEST(Music, IsWrittenAsAMidiFile) {
  const support::TemporaryFile file("music.mid");
  write_midi(file.path(), {{"a", 14, {{0.0, 0.5, 60, 96}, {0.5, 1.0, 62, 50}}}, {"b", 0, {{0.25, 0.25, 70, 127}}}});
  std::ifstream stream(file.path(), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_EQ(bytes.substr(0, 4), "MThd");
  EXPECT_NE(bytes.find("\xC0\x0E"), std::string::npos);      // instrument of the first part
  EXPECT_NE(bytes.find("\x90\x3C\x60"), std::string::npos);  // its first note
  EXPECT_NE(bytes.find("\x91\x46\x7F"), std::string::npos);  // the second part's, on a channel of its own
  EXPECT_NE(bytes.find(std::string("\x80\x3E\x00", 3)), std::string::npos);
}

TEST(Music, IsComposedOfTheChannelAtEqualSteps) {
  const RecordedMotion recorded;
  const auto parts = compose({.every = 0.25, .parts = {rising(1)}}, MotionChannels(recorded.path()), 0.9);
  ASSERT_EQ(parts.size(), 1U);
  const auto& notes = parts[0].notes;
  ASSERT_EQ(notes.size(), 4U);
  const std::vector<int> numbers = {notes[0].number, notes[1].number, notes[2].number, notes[3].number};
  EXPECT_EQ(numbers, (std::vector{60, 64, 67, 69}));  // degrees 0, 1.75, 3.5 and 5.25, rounded
  EXPECT_EQ(notes[1].start, 0.25);
  EXPECT_EQ(notes[2].duration, 0.25);
  EXPECT_NEAR(notes[3].duration, 0.15, 1e-12);  // what is left
  EXPECT_EQ(notes[0].velocity, 96);
}

TEST(Music, SlursEqualNotes) {
  const RecordedMotion recorded;
  MusicPart part = rising(1);
  part.from = {0.0, 100.0};  // the lowest note only
  const auto parts = compose({.every = 0.25, .parts = {part}}, MotionChannels(recorded.path()), 0.9);
  ASSERT_EQ(parts[0].notes.size(), 1U);
  EXPECT_NEAR(parts[0].notes[0].duration, 0.9, 1e-12);
}

TEST(Music, TakesItsVelocityFromAChannel) {
  const RecordedMotion recorded;
  MusicPart part = rising(2);
  part.velocity = MotionVariable{
      .channel = "motion/ball/velocity", .column = "y", .mapping = {.scale = 100.0, .range = {}}, .where = {}};
  const auto notes = compose({.every = 0.25, .parts = {part}}, MotionChannels(recorded.path()), 1.0).at(0).notes;
  ASSERT_EQ(notes.size(), 4U);
  EXPECT_EQ(notes[0].velocity, 1);  // not 0, which would end it
  EXPECT_EQ(notes[1].velocity, 50);
  EXPECT_EQ(notes[2].velocity, 100);
  EXPECT_EQ(notes[3].velocity, 127);
}

}  // namespace idiophone::timbre
