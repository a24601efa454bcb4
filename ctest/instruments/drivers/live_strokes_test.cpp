// Strokes that players lead by OSC and MIDI.

#include "idiophone/instruments/drivers/live_strokes.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "idiophone/instruments/drivers/midi_actions.hpp"

namespace idiophone::drivers {

namespace {

constexpr int rate = 48000;
constexpr auto block = static_cast<std::int64_t>(resonators::RunningStroke::block);

score::Stroke some_roll() {
  score::Stroke stroke;
  stroke.kind = score::Stroke::Kind::roll;
  stroke.to = {0.1, 0.0, 0.0};
  stroke.direction = -Vector3::UnitZ();
  stroke.speed = 0.2;
  stroke.load = 2.0;
  stroke.mass = 0.02;
  stroke.hardness = 1e9;
  return stroke;
}

/// Force at the end of an event's block, N.
double last_force(const Event& event) {
  const auto& forces = std::get<Excitation>(event.action).forces;
  return forces[1].force.back().mean + forces[1].force.back().slope;
}

/// How far the contact goes in an event's block, m.
double way(const Event& event) {
  const auto& forces = std::get<Excitation>(event.action).forces;
  return (forces[1].at - forces[0].at).norm();
}

TEST(LiveStrokes, AskForOneBlockAfterTheOther) {
  constexpr std::int64_t lead = 100;
  LiveStrokes strokes(1, rate, lead);
  strokes.begin("a", 3, some_roll(), 1000);
  std::vector<Event> events;
  for (std::int64_t now = 1000; now < 1000 + 10 * block; now += 128) {
    strokes.ask(now, events);
    ASSERT_FALSE(events.empty());
    EXPECT_GE(events.back().start + block, now + lead + 2 * block) << "what the next call can miss";
  }
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].start, 1000 + lead + static_cast<std::int64_t>(i + 1) * block);
    EXPECT_EQ(events[i].body, 3U);
    EXPECT_EQ(std::get<Excitation>(events[i].action).begins, i == 0);
  }
  strokes.end("a");
  EXPECT_FALSE(strokes.has("a"));
  events.clear();
  strokes.ask(1000 + 20 * block, events);
  EXPECT_EQ(events.size(), 1U) << "in which the load falls";
  EXPECT_EQ(last_force(events.back()), 0.0);
  strokes.ask(1000 + 40 * block, events);
  EXPECT_EQ(events.size(), 1U);
}

TEST(LiveStrokes, AskForBowsAtOnce) {
  score::Bow bow;
  bow.speed.points = bow.load.points = {{0.0, 0.5}};
  LiveStrokes strokes(1, rate, 0);
  strokes.begin("a", 3, bow, 1000);
  std::vector<Event> events;
  strokes.ask(1000, events);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].start, 1000);
  EXPECT_EQ(events[0].body, 3U);
  EXPECT_GT(events[0].sent, 0) << "so that it is left out where it can't be done";
  const auto touching = std::get<Touching>(events[0].action);  // a copy: `events` grows
  EXPECT_TRUE(std::isinf(std::get<score::Bow>(touching.contact).duration));
  strokes.change("a", -0.25, 2.0);
  EXPECT_THROW(strokes.change("a", 0.1, -1.0), std::runtime_error);
  strokes.end("a");
  strokes.ask(1500, events);
  ASSERT_EQ(events.size(), 3U);
  const auto &change = std::get<TouchLead>(events[1].action), &end = std::get<TouchLead>(events[2].action);
  EXPECT_EQ(change.number, touching.number);
  EXPECT_EQ(change.speed, -0.25);
  EXPECT_EQ(change.load, 2.0);
  EXPECT_FALSE(change.ends);
  EXPECT_EQ(end.load, 0.0);
  EXPECT_TRUE(end.ends);
}

TEST(LiveStrokes, RefuseWhatIsWrong) {
  LiveStrokes strokes(1, rate, 0);
  EXPECT_THROW(strokes.change("a", 1.0, 1.0), std::runtime_error);
  EXPECT_THROW(strokes.end("a"), std::runtime_error);
  strokes.begin("a", 0, some_roll(), 0);
  EXPECT_THROW(strokes.begin("a", 0, some_roll(), 0), std::runtime_error);
  EXPECT_THROW(strokes.change("a", -1.0, 1.0), std::runtime_error);
  EXPECT_THROW(strokes.change("a", 1.0, 1e9), std::runtime_error);
  EXPECT_THROW(strokes.change("a", NAN, 1.0), std::runtime_error);
  for (std::size_t i = 1; i < LiveStrokes::most; ++i) {
    strokes.begin(std::to_string(i), 0, some_roll(), 0);
  }
  EXPECT_THROW(strokes.begin("one more", 0, some_roll(), 0), std::runtime_error);
}

TEST(MidiMessages, AreRead) {
  const auto read = [](std::vector<unsigned char> bytes) { return midi_message(bytes).value(); };
  EXPECT_EQ(read({0x93, 60, 100}).number, 60);
  EXPECT_EQ(read({0x93, 60, 100}).value, 100);
  EXPECT_EQ(read({0x93, 60, 0}).kind, MidiMessage::Kind::release);
  EXPECT_EQ(read({0x80, 60, 64}).kind, MidiMessage::Kind::release);
  EXPECT_EQ(read({0xd0, 90}).value, 90);
  EXPECT_EQ(read({0xe0, 0, 64}).value, 0);
  EXPECT_EQ(read({0xe0, 0, 0}).value, -8192);
  EXPECT_EQ(read({0xe0, 127, 127}).value, 8191);
  for (const std::vector<unsigned char>& other : {std::vector<unsigned char>{}, {0x90, 60}, {0xb0, 1, 2}, {0xfe}}) {
    EXPECT_FALSE(midi_message(other).has_value());
  }
}

TEST(MidiActions, LeadAStrokeFromPressToRelease) {
  using Kind = MidiMessage::Kind;
  MidiActions actions({{.note = 60, .body = 2, .blow = {}, .stroke = some_roll()}}, 1, rate, 0);
  std::vector<Event> events;
  std::int64_t now = 0;
  const auto next = [&](const MidiMessage& message) {
    actions.take(message, now, events);
    events.clear();
    now += 4 * block;
    actions.ask(now, events);
    return events.back();
  };
  const double even = 0.2 * static_cast<double>(block) / rate;  // m in a block
  const Event begun = next({.kind = Kind::press, .number = 60, .value = 127});
  EXPECT_EQ(begun.body, 2U);
  EXPECT_NEAR(last_force(begun), 2.0, 1e-9);
  EXPECT_NEAR(way(begun), even, 1e-9);
  EXPECT_NEAR(last_force(next({.kind = Kind::pressure, .value = 64})), 2.0 * 64 / 127, 1e-9);
  EXPECT_NEAR(way(next({.kind = Kind::bend, .value = -4096})), 0.5 * even, 1e-9);
  EXPECT_NEAR(last_force(next({.kind = Kind::release, .number = 60})), 0.0, 1e-12);
  actions.take({.kind = Kind::press, .number = 61, .value = 1}, now, events);
  EXPECT_EQ(actions.unknown(), 1U);
}

TEST(MidiActions, LeadABow) {
  score::Bow bow;
  bow.speed.points = {{0.0, 0.0}, {0.1, 0.2}};
  bow.load.points = {{0.0, 2.0}};
  MidiActions actions({{.note = 60, .body = 2, .blow = {}, .bow = bow}}, 1, rate, 0);
  std::vector<Event> events;
  actions.take({.kind = MidiMessage::Kind::press, .number = 60, .value = 64}, 0, events);
  actions.ask(0, events);
  ASSERT_EQ(events.size(), 1U);
  const auto& begun = std::get<score::Bow>(std::get<Touching>(events[0].action).contact);
  EXPECT_EQ(begun.load.at(0.0), 2.0 * 64 / 127);
  EXPECT_EQ(begun.speed.at(0.05), 0.1);
  actions.take({.kind = MidiMessage::Kind::bend, .value = 8192 / 2}, 0, events);
  actions.ask(0, events);
  EXPECT_NEAR(std::get<TouchLead>(events.back().action).speed, 0.4, 1e-12);
  actions.take({.kind = MidiMessage::Kind::pressure, .value = 127}, 0, events);
  actions.ask(0, events);
  EXPECT_EQ(std::get<TouchLead>(events.back().action).load, 2.0);
  actions.take({.kind = MidiMessage::Kind::release, .number = 60}, 0, events);
  actions.ask(0, events);
  EXPECT_TRUE(std::get<TouchLead>(events.back().action).ends);
}

TEST(MidiActions, StrikeBlowsAsBefore) {
  MidiActions actions({{.note = 60, .body = 1, .blow = {.hammer = {.mass = 0.01, .hardness = 1e8, .speed = 1.0}}}}, 1,
                      rate, 0);
  std::vector<Event> events;
  actions.take({.kind = MidiMessage::Kind::press, .number = 60, .value = 127}, 77, events);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events.front().start, 77);
  EXPECT_GT(events.front().sent, 0);
  EXPECT_NEAR(std::get<Excitation>(events.front().action).strength.impulse, 0.02, 1e-12);
}

TEST(LiveStrokes, EndWhenTheirPlayerIsGone) {
  LiveStrokes strokes(1, rate, 0, 10.0);
  strokes.begin("a", 0, some_roll(), 0);
  std::vector<Event> events;
  strokes.ask(9 * rate, events);
  strokes.change("a", 0.1, 1.0);
  strokes.ask(18 * rate, events);
  EXPECT_TRUE(strokes.has("a")) << "the player spoke of it 9 s ago";
  strokes.ask(20 * rate, events);
  EXPECT_FALSE(strokes.has("a"));
  LiveStrokes held(1, rate, 0);
  held.begin("a", 0, some_roll(), 0);
  held.ask(20 * rate, events);
  EXPECT_TRUE(held.has("a")) << "a key that is down";
}

TEST(MidiActions, AskForNoMoreForceThanFitsIntoMemory) {
  score::HammerBlow soft;  // it touches for 0.5 s
  soft.hammer = {.mass = 1.0, .hardness = 1.25 * std::pow(2.9433 / 0.5, 2.5), .speed = 1.0};
  MidiActions actions({{.note = 60, .body = 0, .blow = soft}}, 1, rate, 0);
  std::vector<Event> events;
  const auto press = [&] { actions.take({.number = 60, .value = 127}, 0, events); };
  for (int i = 0; i < 119; ++i) {
    ASSERT_NO_THROW(press()) << i;
  }
  EXPECT_THROW((press(), press()), std::runtime_error);
}

}  // namespace

}  // namespace idiophone::drivers
