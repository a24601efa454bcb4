// What engines hear is what `play` plays.

#include "idiophone/instruments/engines/engine_stage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/instruments/sound_maps/voice_file.hpp"
#include "performance.hpp"
#include "shared_folder.hpp"
#include "sheet_stage.hpp"
#include "strictness.hpp"
#include "surface_pair.hpp"

namespace idiophone::engines {

namespace {

/// A stage with a sheet that slides for some steps, with its impulses between two bounds in turn.
std::vector<double> slide(EngineStage& stage, int steps, double speed, double least, double most) {
  std::vector<double> sound;
  for (int i = 0; i < steps; ++i) {
    ContactEvent event = blow();
    event.phase = i == 0 ? ContactEvent::Phase::begin : ContactEvent::Phase::persist;
    event.impulse = i % 2 == 0 ? most : least;
    event.slip = {speed, 0, 0};
    stage.contact(event);
    const std::vector<double> more = heard(stage);
    sound.insert(sound.end(), more.begin(), more.end());
  }
  return sound;
}

double loudest(const std::vector<double>& sound) {
  return std::abs(*std::ranges::max_element(sound, {}, [](double pa) { return std::abs(pa); }));
}

double largest_step(const std::vector<double>& sound) {
  double largest = 0.0;
  for (std::size_t i = 1; i < sound.size(); ++i) {
    largest = std::max(largest, std::abs(sound[i] - sound[i - 1]));
  }
  return largest;
}

}  // namespace

TEST(EngineStage, ABlowSoundsAsInPlayToTheBit) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  stage.contact(blow());
  const std::vector<double> found = heard(stage, 30);

  score::Score score;
  score.listener.emplace().receivers = {{.channel = "ear", .position = {0.1, 0.3, 0.8}}};
  const score::HammerBlow struck{
      .at = {0.06, 0.03, 0.0}, .direction = -Vector3::UnitZ(), .hammer = touching::impact_of(0.02, 0.01, steel, steel)};
  score.events = {{.time = 0.25 * duration, .body = 0, .action = struck}};
  voices::Performance performance({sound_maps::sheet()}, score, rate);
  EXPECT_GT(loudest(found), 1e-3);
  EXPECT_EQ(found, performance.rendered(30 * frames));
}

/// The body and the listener turn together: nothing else changes.
TEST(EngineStage, HearsABodyFromWhereItIs) {
  EngineStage still(options(), {sheet_map()}, {steel}), moved(options(), {sheet_map()}, {steel});
  still.contact(blow());
  const double half = std::numbers::sqrt2 / 2.0;  // a quarter turn about x: y becomes z
  moved.place(0, {.position = {5, 6, 7}, .turn = {half, 0, 0, half}});
  moved.listen(std::vector<Triple>{{5.1, 6 - 0.8, 7.3}});
  ContactEvent event = blow();
  event.point = {5.06, 6, 7.03};
  event.normal = {0, 1, 0};
  moved.contact(event);
  const std::vector<double> expected = heard(still, 20), found = heard(moved, 20);
  double difference = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    difference = std::max(difference, std::abs(found[i] - expected[i]));
  }
  EXPECT_LT(difference, 1e-9 * loudest(expected));
}

TEST(EngineStage, BothBodiesOfAContactSound) {
  EngineStage stage(options(), {sheet_map(), sheet_map()}, {steel});
  EngineStage one(options(), {sheet_map()}, {steel});
  ContactEvent event = blow();
  one.contact(event);
  event.bodies = {0, 1};
  stage.contact(event);
  // Opposite forces at the same place of equal bodies cancel.
  EXPECT_LT(loudest(heard(stage, 10)), 1e-12 * loudest(heard(one, 10)));
}

TEST(EngineStage, SlidingHasNoClicksAndNoRateOfThePhysics) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  const std::vector<double> steady = slide(stage, 120, 0.5, 0.01, 0.01);
  EngineStage other(options(), {sheet_map()}, {steel});
  const std::vector<double> trembling = slide(other, 120, 0.5, 0.0, 0.02);
  EXPECT_EQ(stage.report().impacts, 1);
  EXPECT_EQ(other.report().impacts, 1);
  const auto later = [](const std::vector<double>& sound) {
    return std::vector<double>(sound.begin() + 60 * frames, sound.end());
  };
  EXPECT_GT(loudest(later(steady)), 0.0);
  EXPECT_LT(largest_step(later(trembling)), 3.0 * largest_step(later(steady)));
}

TEST(EngineStage, NeverLocksOrAllocatesInTheAudioThread) {
  StageOptions limited = options();
  limited.budget = 0.1;
  EngineStage stage(limited, {sheet_map(), sheet_map()}, {steel});
  std::vector<float> block(frames);
  const long before = plugin::AudioThread::offences();
  for (int i = 0; i < 60; ++i) {
    ContactEvent event = blow();
    event.contact = static_cast<std::uint64_t>(i % 7);
    event.bodies = {i % 2, ContactEvent::nobody};
    event.slip = {0.3, 0, 0};
    stage.contact(event);
    stage.place(0, {.position = {0.01 * i, 0, 0}});
    stage.step(duration);
    const plugin::AudioThread thread;
    stage.render(block, 1.0);
  }
  EXPECT_GT(stage.report().strokes, 0);
  EXPECT_EQ(plugin::AudioThread::offences() - before, 0);
}

TEST(EngineStage, LeavesOutContactsWhileNobodyListens) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  for (int i = 0; i < 60; ++i) {
    stage.contact(blow());
    stage.step(duration);
  }
  EXPECT_GT(stage.report().left_out, 40);
}

/// The listener may be anywhere when a stage is made.
TEST(EngineStage, EarsMayBeFarAway) {
  StageOptions far = options();
  far.ears = {{500, 0, 0}};
  EngineStage stage(far, {sheet_map()}, {steel});
  stage.place(0, {.position = {499, 0, 0}});
  stage.contact(blow());
  EXPECT_GT(largest_step(heard(stage)), 0.0);
}

/// Twice as long: all modes are an octave lower.
TEST(EngineStage, ATunedBodySoundsAsInPlayToTheBit) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  stage.contact(blow());
  std::vector<double> found = heard(stage, 10);
  stage.tune(0, {.friction = 3.0, .size = 2.0});
  const std::vector<double> later = heard(stage, 20);
  found.insert(found.end(), later.begin(), later.end());

  score::Score score;
  score.listener.emplace().receivers = {{.channel = "ear", .position = {0.1, 0.3, 0.8}}};
  const score::HammerBlow struck{
      .at = {0.06, 0.03, 0.0}, .direction = -Vector3::UnitZ(), .hammer = touching::impact_of(0.02, 0.01, steel, steel)};
  score.events = {{.time = 0.25 * duration, .body = 0, .action = struck},
                  {.time = 10 * duration, .body = 0, .action = score::Tuning{.size = 2.0, .friction = 3.0}}};
  voices::Performance performance({sound_maps::sheet()}, score, rate);
  EXPECT_EQ(found, performance.rendered(30 * frames));
  EXPECT_EQ(support::error_of([&] { stage.tune(0, {.tension = 2.0}); }),
            "tune: only proxies have a tension; sound maps have size and friction");
  EXPECT_EQ(support::error_of([&] { stage.tune(0, {.size = 0.0}); }),
            "a tuning has a tension from 1e-4 to 1e4, a friction from 0 to 1e6 and a size from 0.01 to 100");
  EXPECT_EQ(support::error_of([&] { stage.tune(1, {}); }), "there is no body 1");
}

TEST(EngineStage, RefusesWhatIsNotThere) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  const auto refusal = [&](const auto& change) {
    ContactEvent event = blow();
    change(event);
    return support::error_of([&] { stage.contact(event); });
  };
  EXPECT_EQ(refusal([](ContactEvent& event) {
              event.bodies = {0, 1};
            }),
            "a contact is between bodies 0 and 1; the stage has 1");
  EXPECT_EQ(refusal([](ContactEvent& event) { event.bodies = {0, 0}; }), "a contact is between body 0 and itself");
  EXPECT_EQ(refusal([](ContactEvent& event) {
              event.normal = {0, 0, 2};
            }),
            "the normal of a contact is no unit vector");
  EXPECT_EQ(refusal([](ContactEvent& event) { event.mass = 1e-300; }), "a contact moves a mass below 1e-9 kg");
  EXPECT_EQ(refusal([](ContactEvent& event) { event.surfaces = {0, 1}; }), "a contact has surface 1; the stage has 1");
  EXPECT_EQ(refusal([](ContactEvent& event) { event.impulse = std::nan(""); }),
            "a contact has a number that is not finite or above 1e6");
  EXPECT_EQ(support::error_of([&] { stage.step(0.0); }), "a step takes 1e-5 to 1 s");
  EXPECT_EQ(support::error_of([] { EngineStage({}, {}, {}); }), "a stage needs a surface");
}

}  // namespace idiophone::engines
