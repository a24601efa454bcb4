#include "idiophone/instruments/score/score.hpp"

#include "deck_fixture.hpp"

namespace idiophone::score {

using namespace scene;  // decks of tests

namespace {

const std::string score_text = R"(duration: 5
seed: 3
listener: {type: stereo, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0]}
events:
  - {time: 0.1, body: bar, at: [1, 2, 3], direction: [0, 0, -2], mass: 0.02, hardness: 1e8, speed: 1.5}
  - {type: scrape, time: 2, body: bowl, from: [0, 0, 0], to: [1, 0, 0], direction: [0, 0, -1], speed: 0.5, load: 2,
     mass: 0.02, hardness: 1e9, friction: 0.3, roughness: {height: 1e-6, exponent: 2}}
  - {type: force, time: 3, body: bar, at: [0, 0, 0], force: [0, 0, -20], shape: half_sine, duration: 1e-3}
notes:
  - {note: 60, body: bowl, at: [1, 0, 0], direction: [0, 0, -1], mass: 0.1, hardness: 1e7, speed: 2}
wav: pcm24
wav_full_scale: 2
)";

class ScoreTest : public DeckTest {
 protected:
  [[nodiscard]] Score read(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    write("score.yaml", text);
    return read_score(folder / "score.yaml", {"bar", "bowl"}, overrides);
  }

  /// The mistakes of the score with something replaced, without the folder.
  [[nodiscard]] std::string mistakes(const std::string& old, const std::string& by) const {
    try {
      static_cast<void>(read(replaced(score_text, old, by)));
    } catch (const deck::DeckError& error) {
      return replaced(error.what(), folder.string() + "/", "");
    }
    return "";
  }
};

TEST_F(ScoreTest, NotesCanBeStrokes) {
  const std::string roll =
      "type: roll, from: [0, 0, 0], to: [1, 0, 0], direction: [0, 0, -1], speed: 0.2, load: 3, mass: 0.1, "
      "hardness: 1e9, roughness: {height: 1e-7}}";
  const std::string blow = "at: [1, 0, 0], direction: [0, 0, -1], mass: 0.1, hardness: 1e7, speed: 2}";
  const Score score = read(replaced(score_text, blow, roll));
  ASSERT_TRUE(score.notes.at(0).stroke.has_value());
  EXPECT_EQ(score.notes[0].stroke->kind, Stroke::Kind::roll);
  EXPECT_EQ(score.notes[0].stroke->load, 3.0);
  EXPECT_FALSE(read(score_text).notes.at(0).stroke.has_value());
  EXPECT_NE(mistakes(blow, "type: force, " + blow), "");
  EXPECT_NE(mistakes(blow, "type: roll, " + blow), "");
}

TEST_F(ScoreTest, BodiesCanTouch) {
  const auto contact = [&](const std::string& keys) {
    return score_text + "contacts:\n  - {body: bar, at: [0, 0, 0], direction: [0, 0, 2], " + keys + "}\n";
  };
  const auto read_contact = [&](const std::string& keys) { return read(contact(keys)).contacts.at(0); };
  const auto complaint = [&](const std::string& keys) -> std::string {
    try {
      static_cast<void>(read(contact(keys)));
    } catch (const deck::DeckError& error) {
      return error.what();
    }
    return "";
  };
  const BodyContact stop = read_contact("gap: [[0, 1e-3], [2, -1e-5]], hardness: 1e6, exponent: 1, loss: 0.3");
  EXPECT_EQ(stop.direction, Vector3::UnitZ());
  EXPECT_NEAR(stop.gap.at(1.0), 4.95e-4, 1e-12);
  EXPECT_EQ(stop.elasticity.exponent, 1.0);
  EXPECT_FALSE(stop.other || stop.mass);
  EXPECT_EQ(read_contact("gap: 0, hardness: 1e6, other: {body: bowl, at: [0, 0, 1]}").other->body, 1U);
  EXPECT_EQ(read_contact("gap: 0, hardness: 1e6, mass: 0.002, load: 0.02").mass->load, 0.02);
  // Hertz: a steel ball of 10 mm on a flat of the same steel, 4/3 E/(2 (1 - nu^2)) sqrt(R).
  const std::string steel = "{young: 2.1e11, poisson: 0.3";
  EXPECT_NEAR(read_contact("gap: 0, surfaces: [" + steel + ", radius: 0.01}, " + steel + "}]").elasticity.hardness,
              1.5385e10, 1e6);
  EXPECT_GT(read_contact("gap: 0, surfaces: [{material: steel, radius: 0.01}, {material: brass}]").elasticity.hardness,
            1e9);
  EXPECT_NE(complaint("gap: 0, surfaces: [{material: steel}, {material: brass}]").find("at a point"),
            std::string::npos);
  EXPECT_NE(complaint("gap: 0, surfaces: [{material: spruce, radius: 0.01}, {material: brass}]"), "");
  EXPECT_NE(complaint("gap: 0, surfaces: [{material: steel, radius: 0.01}]").find("not 1"), std::string::npos);
  EXPECT_NE(complaint("gap: 0, hardness: 1e6, load: 1").find("loose mass"), std::string::npos);
  EXPECT_NE(complaint("gap: -1, hardness: 1e6"), "");
  EXPECT_NE(complaint("gap: -1e-5, hardness: 1e6, mass: 0.1, load: 1").find("height"), std::string::npos);
  EXPECT_NE(
      complaint("gap: 0, hardness: 1e6, mass: 0.1, load: 1, other: {body: bowl, at: [0, 0, 0]}").find("leave out"),
      std::string::npos);
  EXPECT_NE(complaint("hardness: 1e6"), "");
}

TEST_F(ScoreTest, BowsHaveCoursesOverTime) {
  const std::string bow =
      "{type: bow, body: bar, at: [0, 0, 0], direction: [0, 2, 0], speed: [[0, 0], [0.5, 0.2]], load: 3";
  const auto read_bow = [](const std::string& text) {
    return std::get<Bow>(read_event(text, "OSC /event", {"bar", "bowl"}).action);
  };
  const Bow found = read_bow(bow + ", friction: {sliding: 0.4}}");
  EXPECT_EQ(found.direction, Vector3::UnitY());
  EXPECT_EQ(found.speed.at(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(found.speed.at(0.25), 0.1);
  EXPECT_EQ(found.speed.at(9.0), 0.2);
  EXPECT_EQ(found.load.at(1.0), 3.0);
  EXPECT_EQ(found.friction.sliding, 0.4);
  EXPECT_EQ(found.friction.sticking, friction::Law().sticking);
  for (const char* wrong : {", friction: {sliding: 0.9}}", ", friction: {break_away: 1}}", ", duration: 61}",
                            ", load: -1}", ", mass: 1}"}) {
    EXPECT_THROW(read_bow(bow + wrong), deck::DeckError) << wrong;
  }
  EXPECT_THROW(read_bow(replaced(bow, "[0.5,", "[0,") + "}"), deck::DeckError) << "times that do not ascend";
  EXPECT_THROW(read_bow(replaced(bow, "[[0, 0], [0.5, 0.2]]", "[]") + "}"), deck::DeckError);
}

TEST_F(ScoreTest, SaysWhatHappensAndWhen) {
  const Score score = read(score_text);
  EXPECT_EQ(score.duration, 5.0);
  EXPECT_EQ(score.seed, 3U);
  EXPECT_EQ(score.listener->receivers.size(), 2U);
  EXPECT_EQ(score.wav, scene::WavFormat::pcm24);
  EXPECT_EQ(score.wav_full_scale, 2.0);
  ASSERT_EQ(score.events.size(), 3U);
  EXPECT_EQ(score.events[0].time, 0.1);
  EXPECT_EQ(score.events[0].body, 0U);
  const auto& blow = std::get<HammerBlow>(score.events[0].action);
  EXPECT_EQ(blow.at, Vector3(1, 2, 3));
  EXPECT_EQ(blow.direction, Vector3(0, 0, -1));
  EXPECT_EQ(blow.hammer.hardness, 1e8);
  const auto& scrape = std::get<Stroke>(score.events[1].action);
  EXPECT_EQ(score.events[1].body, 1U);
  EXPECT_EQ(scrape.kind, Stroke::Kind::scrape);
  EXPECT_EQ(scrape.roughness.exponent, 2.0);
  EXPECT_EQ(scrape.roughness.longest, 5e-3);
  EXPECT_EQ(std::get<AppliedForce>(score.events[2].action).signal.at(0.5e-3), 1.0);
  ASSERT_EQ(score.notes.size(), 1U);
  EXPECT_EQ(score.notes[0].blow.hammer.speed, 2.0);
}

TEST_F(ScoreTest, TakesOverrides) {
  EXPECT_EQ(read(score_text, {"duration=7", "events.0.time=0.5"}).events[0].time, 0.5);
}

TEST_F(ScoreTest, NeedsNoBodyIfThereIsOne) {
  write("score.yaml",
        "duration: 1\nevents: [{time: 0, at: [0, 0, 0], direction: [0, 0, 1], mass: 1, hardness: 1e8, speed: 1}]\n");
  EXPECT_EQ(read_score(folder / "score.yaml", {"bar"}, {}).events.at(0).body, 0U);
}

TEST_F(ScoreTest, ReportsMistakesWithTheirPlaces) {
  EXPECT_EQ(mistakes("body: bowl, from", "body: bolw, from"),
            "score.yaml:6:35: events.1.body: must be one of bar, bowl, found 'bolw' (did you mean 'bowl'?)");
  EXPECT_EQ(mistakes("duration: 5\n", "duration: -5\n"),
            "score.yaml:1:11: duration: must be above 0 and at most 86400 s, found -5");
  EXPECT_THAT(mistakes("hardness: 1e8", "hardnes: 1e8"), testing::HasSubstr("score.yaml:5:"));
  EXPECT_THAT(mistakes("to: [1, 0, 0]", "to: [0, 0, 0]"), testing::HasSubstr("the contact must move"));
  EXPECT_THAT(mistakes("exponent: 2", "shortest: 1e-2"), testing::HasSubstr("must be below the longest"));
  EXPECT_THAT(mistakes("type: scrape", "type: roll"), testing::HasSubstr("a body that rolls does not slide"));
  EXPECT_THAT(mistakes("speed: 0.5", "speed: 1e-4"), testing::HasSubstr("a stroke can take 60 s"));
  EXPECT_THAT(mistakes("shape: half_sine, duration: 1e-3", "shape: constant"),
              testing::HasSubstr("a force has to end within 60 s"));
  EXPECT_THAT(mistakes("hardness: 1e8, speed: 1.5", "hardness: 1, speed: 0.01"),
              testing::HasSubstr("a blow can take 1 s"));
  EXPECT_THAT(mistakes("type: scrape", "type: tune, size: 0"), testing::HasSubstr("size: must be at least 0.01"));
  EXPECT_THAT(mistakes("wav: pcm24", "waf: pcm24"), testing::HasSubstr("did you mean 'wav'?"));
  EXPECT_THAT(
      mistakes("  - {note: 60, body: bowl",
               "  - {note: 60, body: bar, at: [1, 0, 0], direction: [0, 0, -1], mass: 0.1, hardness: 1e7, speed: 2}\n"
               "  - {note: 60, body: bowl"),
      testing::HasSubstr("note 60 is there twice"));
}

TEST_F(ScoreTest, RefusesListenersThatAreTooFast) {
  write("path.csv", "0, 0, 0, 0\n1, 200, 0, 0\n");
  EXPECT_THAT(mistakes("position: [0, 0, 1]", "path: path.csv"), testing::HasSubstr("moves at up to 200 m/s"));
}

TEST_F(ScoreTest, TunesABodyAndHearsWithAHead) {
  const Score score = read(
      "duration: 1\nlistener: {type: binaural, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0]}\n"
      "events: [{time: 0.5, type: tune, body: bowl, size: 2}]\n");
  EXPECT_TRUE(score.listener->head.has_value());
  EXPECT_EQ(score.events.at(0).body, 1U);
  const auto& tuning = std::get<Tuning>(score.events[0].action);
  EXPECT_EQ(tuning.size, 2.0);
  EXPECT_EQ(tuning.friction, 1.0);
}

TEST_F(ScoreTest, ReadsOneEventThatHappensAtOnce) {
  const std::string text = "{body: bowl, at: [1, 2, 3], direction: [0, 0, 1], mass: 1, hardness: 1e8, speed: 1}";
  EXPECT_EQ(read_event(text, "OSC /event", {"bar", "bowl"}).body, 1U);
  EXPECT_THROW(static_cast<void>(read_event(replaced(text, "{body", "{time: 1, body"), "OSC /event", {"bar", "bowl"})),
               deck::DeckError);
  EXPECT_THROW(static_cast<void>(read_event("no map", "OSC /event", {"bar"})), deck::DeckError);
}

}  // namespace

}  // namespace idiophone::score
