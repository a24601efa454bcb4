#include "idiophone/instruments/drivers/score_notes.hpp"

#include <gtest/gtest.h>

#include "idiophone/instruments/drivers/players.hpp"

namespace idiophone::drivers {

namespace {

score::NoteAction action(int note, std::size_t body, double x, double speed) {
  return {
      .note = note, .body = body, .blow = {.at = {x, 0, 0}, .hammer = {.mass = 0.01, .hardness = 1e7, .speed = speed}}};
}

const std::vector<score::NoteAction> actions = {action(60, 0, 0.0, 2.0), action(62, 0, 0.1, 1.0),
                                                action(70, 1, 0.0, 1.0)};

}  // namespace

TEST(ScoreNotes, AreTheReverseOfTheBlowsOfNotes) {
  const std::vector<Note> notes = {{0.1, 60, 127}, {0.2, 62, 1}, {0.2, 70, 64}, {0.3, 60, 33}};
  const ScoreNotes found = notes_of(blows_of(notes, actions).events, actions);
  EXPECT_EQ(found.left_out, 0U);
  ASSERT_EQ(found.notes.size(), notes.size());
  for (std::size_t i = 0; i < notes.size(); ++i) {
    EXPECT_EQ(found.notes[i].time, notes[i].time);
    EXPECT_EQ(found.notes[i].number, notes[i].number);
    EXPECT_EQ(found.notes[i].velocity, notes[i].velocity);
  }
}

TEST(ScoreNotes, AreTheNearestOnesOfTheBody) {
  score::HammerBlow blow{.at = {0.06, 0, 0}, .hammer = {.mass = 0.02, .hardness = 1e7, .speed = 5.0}};
  const std::vector<score::ScoreEvent> events = {
      {0.5, 0, blow}, {0.1, 1, blow}, {0.2, 2, blow}, {0.3, 0, score::Tuning{.size = 2.0}}};
  const ScoreNotes found = notes_of(events, actions);
  EXPECT_EQ(found.left_out, 2U);  // a body without notes, and no blow
  ASSERT_EQ(found.notes.size(), 2U);
  EXPECT_EQ(found.notes[0].number, 70);
  EXPECT_EQ(found.notes[1].number, 62);
  EXPECT_EQ(found.notes[1].velocity, 127);  // the loudest that there is
}

TEST(ScoreNotes, EndInTimeForTheNextBlow) {
  const auto messages = messages_of({{0.0, 60, 100}, {0.1, 60, 90}, {0.2, 62, 80}});
  ASSERT_EQ(messages.size(), 6U);
  const std::vector<int> kinds = {0x90, 0x80, 0x90, 0x90, 0x80, 0x80};
  const std::vector<double> times = {0.0, 0.1, 0.1, 0.2, 0.35, 0.45};
  for (std::size_t i = 0; i < messages.size(); ++i) {
    EXPECT_EQ(messages[i].bytes[0], kinds[i]);
    EXPECT_NEAR(messages[i].time, times[i], 1e-12);
    EXPECT_EQ(messages[i].count, 3U);
  }
  EXPECT_EQ(messages[2].bytes[2], 90);
}

}  // namespace idiophone::drivers
