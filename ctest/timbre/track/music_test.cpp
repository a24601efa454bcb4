#include "music.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "ranks.hpp"
#include "recorded_motion.hpp"

namespace idiophone::timbre {

namespace {

std::size_t scale_named(const std::string& name) {
  const auto& scales = musical_scales();
  return static_cast<std::size_t>(std::ranges::find(scales, name, &std::pair<std::string, std::vector<int>>::first) -
                                  scales.begin());
}

MotionVariable velocity_along(const std::string& column, const Mapping& mapping = {}) {
  return {.channel = "motion/ball/velocity", .column = column, .mapping = mapping, .where = {}};
}

/// A part whose notes follow the ball's velocity along x, 0 to 1 m/s in a second.
MusicPart rising(int octaves) {
  return {.name = "a",
          .pitch = velocity_along("x"),
          .from = {0.0, 1.0},
          .scale = scale_named("ionian"),
          .tonic = 60,
          .octaves = octaves};
}

/// The notes of a scene's only part, for a while (s).
std::vector<ScoreNote> notes_of(const MusicPart& part, double duration, double every = 0.25) {
  const RecordedMotion recorded;
  SonicScene scene;
  scene.music = {.every = every, .parts = {part}};
  const MusicScore score = compose(scene, MotionChannels(recorded.path()), duration);
  EXPECT_EQ(score.parts.size(), 1U);
  return score.parts.at(0).notes;
}

template <class Property>
std::vector<int> all(const std::vector<ScoreNote>& notes, Property property) {
  std::vector<int> values;
  std::ranges::transform(notes, std::back_inserter(values), property);
  return values;
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
  MusicScore score{.title = "m", .every = 0.5, .duration = 2.0};
  score.parts = {{.name = "a", .notes = {{0, 1, 60, 96, 14}, {1, 2, 62, 50, 14}, {3, 1, 64, 50, 15}}},
                 {.name = "b", .notes = {{1, 1, 70, 127, 0}}}};
  write_midi(file.path(), score);
  std::ifstream stream(file.path(), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_EQ(bytes.substr(0, 4), "MThd");
  EXPECT_NE(bytes.find("\xC0\x0E"), std::string::npos);                           // instrument of the first part
  EXPECT_NE(bytes.find("\x90\x3C\x60"), std::string::npos);                       // its first note
  EXPECT_LT(bytes.find(std::string("\x80\x3E\x00", 3)), bytes.find("\xC0\x0F"));  // the instrument changes after it
  EXPECT_EQ(bytes.find("\xC0\x0E"), bytes.rfind("\xC0\x0E"));                     // and is not repeated
  EXPECT_NE(bytes.find("\x91\x46\x7F"), std::string::npos);  // the second part's, on a channel of its own
}

TEST(Music, IsComposedOfTheChannelAtEqualSteps) {
  const auto notes = notes_of(rising(1), 0.9);
  EXPECT_EQ(all(notes, &ScoreNote::number), (std::vector{60, 64, 67, 69}));  // degrees 0, 1.75, 3.5 and 5.25, rounded
  EXPECT_EQ(all(notes, &ScoreNote::start), (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(all(notes, &ScoreNote::length), (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(notes[0].velocity, 96);
}

TEST(Music, SlursEqualNotes) {
  MusicPart part = rising(1);
  part.from = {0.0, 100.0};  // the lowest note only
  EXPECT_EQ(all(notes_of(part, 0.9), &ScoreNote::length), (std::vector{4}));
  part.program = velocity_along("x", {.scale = 20.0, .range = {}});
  EXPECT_EQ(all(notes_of(part, 0.9), &ScoreNote::program), (std::vector{0, 5, 10, 15}));  // other instruments
}

TEST(Music, TakesItsVelocityFromAChannel) {
  MusicPart part = rising(2);
  part.velocity = velocity_along("y", {.scale = 100.0, .range = {}});
  // Not 0, which would end it.
  EXPECT_EQ(all(notes_of(part, 1.0), &ScoreNote::velocity), (std::vector{1, 50, 100, 127}));
}

TEST(Music, HasLengthsThatFollowTheMotion) {
  MusicPart part = rising(1);
  part.from = {0.0, 100.0};
  part.steps = velocity_along("x", {.scale = 10.0, .range = {}});  // at 0, 0.1, 0.2 and 0.4 s, in steps of 0.1 s
  const auto notes = notes_of(part, 1.0, 0.1);
  EXPECT_EQ(all(notes, &ScoreNote::start), (std::vector{0, 1, 2, 4, 8}));
  EXPECT_EQ(all(notes, &ScoreNote::length), (std::vector{1, 1, 2, 4, 2}));  // the last one ends with the scene
}

TEST(Music, RestsWhileAValueIsLow) {
  MusicPart part = rising(1);
  part.from = {0.0, 100.0};
  part.rests = Rests{.value = Keyframes{.keys = {{0.0, 1.0}, {0.25, 0.0}, {0.5, 1.0}}}, .below = 0.5};
  const auto notes = notes_of(part, 1.0);
  EXPECT_EQ(all(notes, &ScoreNote::start), (std::vector{0, 2}));  // no slur over the rest
  EXPECT_EQ(all(notes, &ScoreNote::length), (std::vector{1, 2}));
}

TEST(Music, IsMappedByATreeOfSeveralChannels) {
  const support::TemporaryFile tree("sum.tt");
  std::ofstream(tree.path()) << "(parameter a)(parameter b)(parameter c 0)(- (* 2 b) (* 3 a) c)";
  const RecordedMotion recorded;
  MusicPart part = rising(1);
  part.pitch = TreeVariable{.sound_class = 0,
                            .parameters = {{.name = "a", .variable = velocity_along("x"), .where = {}},
                                           {.name = "b", .variable = velocity_along("y"), .where = {}}}};
  SonicScene scene;
  scene.classes = {{.name = "sum", .tree = tree.path()}};
  scene.music = {.every = 0.25, .parts = {part}};
  const MotionChannels motion(recorded.path());
  // 2 (2 t) - 3 t = t: as the velocity along x alone
  EXPECT_EQ(all(compose(scene, motion, 0.9).parts[0].notes, &ScoreNote::number), (std::vector{60, 64, 67, 69}));
  std::ofstream(tree.path()) << "(parameter a)(parameter b)(* b (floor (* 4 time)))";
  EXPECT_EQ(all(compose(scene, motion, 0.9).parts[0].notes, &ScoreNote::number), (std::vector{60, 67, 72}));
  std::ofstream(tree.path()) << "(parameter a)(+ a 1)";
  EXPECT_THROW(static_cast<void>(compose(scene, motion, 0.0)), deck::DeckError);  // the tree has no parameter b
}

}  // namespace idiophone::timbre
