// Proxies on a stage: what engines hear is what `play` plays.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "bodies.hpp"
#include "idiophone/instruments/drivers/players.hpp"
#include "idiophone/instruments/proxies/proxy_file.hpp"
#include "idiophone/instruments/voices/proxy_voices.hpp"
#include "idiophone/instruments/voices/stage.hpp"
#include "shared_folder.hpp"
#include "sheet_stage.hpp"
#include "strictness.hpp"
#include "surface_pair.hpp"

namespace idiophone::engines {

namespace {

constexpr Triple ear = {0.1, 0.3, 0.8};

/// A cube of rubber of 0.1 m, in two levels.
SharedProxy cube() {
  return std::make_shared<const proxies::StoredBody>(
      proxies::StoredBody{.name = "cube", .levels = {proxies::rubber_cube(4), proxies::rubber_cube(2)}});
}

ContactEvent tap(std::size_t body = 0) {
  ContactEvent event = blow();
  event.contact = body;
  event.bodies = {static_cast<std::int32_t>(body), ContactEvent::nobody};
  event.point = {0.04, 0.06, 0.1};
  return event;
}

void append(std::vector<double>& sound, const std::vector<double>& more) {
  sound.insert(sound.end(), more.begin(), more.end());
}

/// What `play` makes of the cube and these events.
std::vector<double> played(const std::vector<score::ScoreEvent>& events, std::int64_t samples) {
  scene::Listener listener;
  listener.receivers = {{.channel = "ear", .position = Vector3(ear[0], ear[1], ear[2])}};
  const voices::Audience audience(std::move(listener));
  const SharedProxy body = cube();
  proxies::Engine engine({.rate = rate});
  engine.add({.name = "cube", .levels = body->levels});
  const Vector3 centre = body->levels.front()->body_inertia().centre;
  std::vector<std::unique_ptr<voices::Voice>> all;
  all.push_back(std::make_unique<voices::ProxyVoices>(
      std::move(engine), std::vector<voices::ProxyBody>{{.name = "cube", .centre = centre, .track = {}}}, audience,
      voices::ProxyHearing{.rate = rate}));
  voices::Stage stage(audience, std::move(all), 1, rate);
  drivers::Drivers drivers;
  drivers.push_back(std::make_unique<drivers::ScoreDriver>(events, 1, rate));
  return voices::rendered(stage, drivers, samples);
}

/// Of the coarse level of the cube at the full rate, processor time per time of sound.
double coarse_cost() {
  proxies::Engine engine({.rate = rate});
  engine.add({.name = "cube", .levels = cube()->levels});
  return engine.cost(0, 1, 1) / voices::usual_speed;
}

/// Two cubes beside a sheet, one of which joins before a step; the sheet and both cubes are struck.
std::vector<double> sheet_and_cubes(int joins) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  const SharedProxy proxy = cube();
  std::vector<double> sound;
  for (int step = 0; step < 20; ++step) {
    if (step == 0 && joins != 0) {
      EXPECT_EQ(stage.add(proxy), 1U);
    }
    if (step == joins) {
      stage.add(proxy);
      EXPECT_EQ(joins == 0 ? stage.add(proxy) : 2U, 2U);
    }
    if (step == 5) {
      stage.contact(blow());
      stage.contact(tap(1));
    }
    if (step == 10) {
      stage.place(2, {.position = {0.0, 0.0, 0.5}});
      ContactEvent event = tap(2);
      event.point[2] += 0.5;
      stage.contact(event);
    }
    append(sound, heard(stage));
  }
  return sound;
}

}  // namespace

TEST(StageProxies, ABlowAndATuningSoundAsInPlayToTheBit) {
  EngineStage stage(options(), {}, {steel});
  EXPECT_EQ(stage.add(cube()), 0U);
  stage.contact(tap());
  std::vector<double> found = heard(stage, 4);
  stage.tune(0, {.tension = 2.0, .friction = 0.5, .size = 1.1});
  append(found, heard(stage, 6));
  const score::HammerBlow struck{
      .at = {0.04, 0.06, 0.1}, .direction = -Vector3::UnitZ(), .hammer = touching::impact_of(0.02, 0.01, steel, steel)};
  const score::Tuning tuning{.size = 1.1, .friction = 0.5, .tension = 2.0};
  EXPECT_GT(peak(found), 1e-3);
  EXPECT_EQ(found, played({{.time = 0.25 * duration, .body = 0, .action = struck},
                           {.time = 4 * duration, .body = 0, .action = tuning}},
                          10 * frames));
}

TEST(StageProxies, ReadFromAFileSoundsTheSame) {
  const SharedProxy proxy = cube();
  const SharedProxy read = read_proxy(proxies::proxy_file(*proxy), "cube.proxy");
  EngineStage stage(options(), {}, {steel}), again(options(), {}, {steel});
  stage.add(proxy);
  again.add(read);
  stage.contact(tap());
  again.contact(tap());
  const std::vector<double> found = heard(again, 5);
  EXPECT_GT(peak(found), 1e-3);
  EXPECT_EQ(found, heard(stage, 5));
  EXPECT_EQ(support::error_of([] { (void)read_proxy("no proxy", "cube.proxy"); }).substr(0, 24),
            "cube.proxy is no proxy f");
  const BodyFacts facts = facts_of(read);
  EXPECT_EQ(facts.body, "cube");
  EXPECT_NEAR(facts.mass, 1.0, 1e-12);
  EXPECT_NEAR(facts.centre[1], 0.05, 1e-9);
  EXPECT_EQ(facts.high[0], 0.1);
  EXPECT_EQ(facts.young, 1e6);
}

TEST(StageProxies, WhoJoinsSoundsAsIfItHadBeenThere) {
  const std::vector<double> expected = sheet_and_cubes(0);
  EXPECT_GT(peak({expected.begin() + 10 * frames, expected.end()}), 1e-3);
  EXPECT_EQ(sheet_and_cubes(3), expected);
  EXPECT_EQ(sheet_and_cubes(10), expected);
}

/// The body and the listener turn together: nothing else changes.
TEST(StageProxies, AreHeardFromWhereTheyAre) {
  EngineStage still(options(), {}, {steel}), moved(options(), {}, {steel});
  still.add(cube());
  moved.add(cube());
  const double half = std::numbers::sqrt2 / 2.0;  // a quarter turn about x: y becomes z
  moved.place(0, {.position = {5, 6, 7}, .turn = {half, 0, 0, half}});
  moved.listen(std::vector<Triple>{{5 + ear[0], 6 - ear[2], 7 + ear[1]}});
  heard(moved);  // the listener goes there within a step
  heard(still);
  ContactEvent event = tap();
  event.point = {5.04, 5.9, 7.06};
  event.normal = {0, 1, 0};
  moved.contact(event);
  still.contact(tap());
  const std::vector<double> expected = heard(still, 10), found = heard(moved, 10);
  double difference = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    difference = std::max(difference, std::abs(found[i] - expected[i]));
  }
  EXPECT_GT(peak(expected), 1e-3);
  EXPECT_LT(difference, 1e-9 * peak(expected));
}

/// As above, also if it is put there in the step in which it is struck.
TEST(StageProxies, AreHeardAtOnceFromWhereTheyArePut) {
  const auto sound_of = [](int placed) {
    EngineStage stage(options(), {}, {steel});
    stage.add(cube());
    std::vector<double> sound;
    for (int step = 0; step < 6; ++step) {
      if (step == placed) {
        stage.place(0, {.position = {0.2, -0.5, 1.0}, .turn = {0.3, 0.5, 0.1, 0.8}});
      }
      if (step == 1) {
        ContactEvent event = tap();
        event.point = {0.25, -0.45, 1.05};
        event.moment = 0.0;
        stage.contact(event);
      }
      append(sound, heard(stage));
    }
    return sound;
  };
  const std::vector<double> expected = sound_of(0);
  EXPECT_GT(peak(expected), 1e-3);
  EXPECT_EQ(sound_of(1), expected);
}

TEST(StageProxies, Scrape) {
  EngineStage stage(options(), {}, {steel});
  stage.add(cube());
  std::vector<double> sound;
  for (int step = 0; step < 40; ++step) {
    ContactEvent event = tap();
    event.impulse = 0.01;
    event.slip = {0.5, 0, 0};
    stage.contact(event);
    append(sound, heard(stage));
  }
  EXPECT_EQ(stage.report().strokes, 1U);
  EXPECT_GT(peak({sound.begin() + 20 * frames, sound.end()}), 0.0);
}

TEST(StageProxies, WhoLeavesFadesAndItsNumberIsFree) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  const SharedProxy proxy = cube();
  EXPECT_EQ(stage.add(proxy), 1U);
  stage.contact(tap(1));
  const std::vector<double> before = heard(stage);
  stage.remove(1);
  EXPECT_EQ(support::error_of([&] { stage.place(1, {}); }), "there is no body 1");
  EXPECT_EQ(support::error_of([&] { stage.contact(tap(1)); }), "there is no body 1");
  EXPECT_EQ(stage.add(sheet_map()), 2U) << "it has not faded";
  const std::vector<double> fading = heard(stage);
  EXPECT_GT(peak(fading), 0.0);
  EXPECT_LE(steepest(fading), 1.01 * steepest(before));
  EXPECT_EQ(peak(heard(stage, 3)), 0.0);
  EXPECT_EQ(stage.add(sheet_map()), 1U);
  EXPECT_EQ(stage.add(proxy), 3U);
  stage.contact(tap(3));
  EXPECT_EQ(heard(stage), before) << "the new one sounds like the first";
}

TEST(StageProxies, NeverLockOrAllocateInTheAudioThread) {
  StageOptions limited = options();
  limited.budget = 0.5;
  EngineStage stage(limited, {sheet_map()}, {steel});
  const SharedProxy proxy = cube();
  std::vector<float> block(frames);
  double loudest = 0.0;
  const long before = plugin::AudioThread::offences();
  for (int step = 0; step < 40; ++step) {
    const std::size_t body = stage.add(proxy);
    stage.contact(tap(body));
    stage.place(body, {.position = {0.01 * step, 0, 0}});
    stage.tune(body, {.tension = 1.5});
    stage.step(duration);
    {
      const plugin::AudioThread thread;
      stage.render(block, 1.0);
    }
    loudest = std::max(loudest, static_cast<double>(*std::ranges::max_element(block)));
    stage.remove(body);
  }
  EXPECT_GT(loudest, 1e-3);
  EXPECT_LT(stage.add(proxy), 6U) << "numbers are used again";
  EXPECT_EQ(plugin::AudioThread::offences() - before, 0);
}

/// What a budget has room for: the fine level, the coarse one, and nothing.
TEST(StageProxies, ABudgetChoosesTheirLevel) {
  const auto report_with = [](double budget) {
    StageOptions limited = options();
    limited.budget = budget;
    EngineStage stage(limited, {}, {steel});
    stage.add(cube());
    stage.contact(tap());
    stage.step(duration);
    return stage.report();
  };
  const StageReport fine = report_with(1e9);
  EXPECT_EQ(fine.proxies, 1U);
  EXPECT_GT(fine.proxy_cost, 0.0);
  const StageReport coarse = report_with(fine.proxy_cost);  // of which 85 % are spent
  EXPECT_EQ(coarse.proxies, 1U);
  EXPECT_DOUBLE_EQ(coarse.proxy_cost, coarse_cost());
  const StageReport none = report_with(0.5 * coarse.proxy_cost);
  EXPECT_EQ(none.proxies, 0U);
  EXPECT_EQ(none.left_out, 1U);
}

/// Maps and proxies share the budget: a map that is heard better leaves no room.
TEST(StageProxies, ShareTheBudgetWithMaps) {
  const auto report_with = [](double budget, double impulse_on_map) {
    StageOptions limited = options();
    limited.budget = budget;
    EngineStage stage(limited, {sheet_map()}, {steel});
    stage.add(cube());
    ContactEvent event = blow();
    event.impulse = impulse_on_map;
    stage.contact(event);
    heard(stage, 3);
    stage.contact(tap(1));
    stage.step(duration);
    return stage.report();
  };
  const StageReport all = report_with(1e9, 1e3);
  EXPECT_EQ(all.proxies, 1U);
  const double budget = (0.5 * all.cost + coarse_cost()) / 0.85;
  EXPECT_EQ(report_with(budget, 0.0).proxies, 1U);
  const StageReport shared = report_with(budget, 1e3);
  EXPECT_GT(shared.heard, 0U);
  EXPECT_EQ(shared.proxies, 0U);
  EXPECT_EQ(shared.left_out, 1U);
}

TEST(StageProxies, OnlyTheLoudestOfManySound) {
  StageOptions limited = options();
  limited.most_proxies = 2;
  EngineStage stage(limited, {}, {steel});
  for (std::size_t body = 0; body < 3; ++body) {
    stage.add(cube());
    ContactEvent event = tap(body);
    event.impulse *= 3.0 - static_cast<double>(body);
    stage.contact(event);
  }
  stage.step(duration);
  EXPECT_EQ(stage.report().proxies, 2U);
  EXPECT_EQ(stage.report().left_out, 1U);
}

/// The game stops for some time while a body rings: the sound falls and rises again without a click, and goes on.
TEST(StageProxies, ALateStepMakesAPauseWithoutAClick) {
  EngineStage stage(options(), {}, {steel}), other(options(), {}, {steel});
  stage.add(cube());
  other.add(cube());
  stage.contact(tap());
  other.contact(tap());
  const std::vector<double> expected = heard(other, 6);
  std::vector<double> sound = heard(stage, 2);
  std::vector<double> late(frames);
  stage.render(late);
  append(sound, late);
  append(sound, heard(stage, 4));
  EXPECT_EQ(stage.report().gaps, 1U);
  EXPECT_EQ(other.report().gaps, 0U);
  EXPECT_LT(std::abs(late.back()), 1e-6 * peak(expected));
  EXPECT_LE(steepest({sound.begin() + frames, sound.end()}),
            1.01 * steepest({expected.begin() + frames, expected.end()}));
  double difference = 0.0;
  for (std::size_t i = 4UL * frames; i < 6UL * frames; ++i) {
    difference = std::max(difference, std::abs(sound[i + frames] - expected[i]));
  }
  EXPECT_LT(difference, 1e-6 * peak(expected)) << "what rang goes on where it was";
}

/// As in a game that plays on behind its menu.
TEST(StageProxies, AFirstOneJoinsAfterALongPause) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  std::vector<double> silence(10UL * rate);
  stage.render(silence);
  const std::size_t body = stage.add(cube());
  stage.render(silence);
  heard(stage);
  stage.contact(tap(body));
  const std::vector<double> found = heard(stage, 5);
  EngineStage other(options(), {}, {steel});
  other.add(cube());
  other.contact(tap());
  EXPECT_EQ(found, heard(other, 5));
}

TEST(StageProxies, SoundWithLatencyWhileAnotherThreadRenders) {
  EngineStage stage(options(0.05), {sheet_map()}, {steel});
  AudioThread audio(stage);
  const SharedProxy proxy = cube();
  for (int step = 0; step < 200 || (!audio.sounds() && step < 20000); ++step) {
    const std::size_t body = stage.add(proxy);
    stage.contact(tap(body));
    stage.step(duration);
    stage.remove(body);
  }
  audio.end();
  EXPECT_TRUE(audio.is_finite());
  EXPECT_TRUE(audio.sounds());
}

TEST(StageProxies, RefusesWhatCantBe) {
  EngineStage stage(options(), {}, {steel});
  stage.add(cube());
  EXPECT_EQ(support::error_of([&] { stage.add(SharedProxy()); }), "a body has no proxy");
  EXPECT_NE(support::error_of([&] { stage.tune(0, {.tension = 1e4, .size = 0.01}); }), "");
  EXPECT_EQ(support::error_of([&] { stage.tune(1, {}); }), "there is no body 1");
  StageOptions silent = options();
  silent.most_proxies = 0;
  EXPECT_EQ(support::error_of([&] { EngineStage(silent, {}, {steel}); }), "at least one proxy may sound");
}

}  // namespace idiophone::engines
