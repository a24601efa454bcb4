// Bodies that join a stage and leave it while it plays.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "shared_folder.hpp"
#include "sheet_stage.hpp"
#include "strictness.hpp"

namespace idiophone::engines {

namespace {

ContactEvent blow_at(std::size_t body) {
  ContactEvent event = blow();
  event.contact = body;
  event.bodies = {static_cast<std::int32_t>(body), ContactEvent::nobody};
  return event;
}

/// A body that is struck at once and again, and another one that is struck in the tenth step. The listener moves
/// before.
/// @param joins  step before which the other one joins; below 0: it is there from the start
std::vector<double> two_bodies(int joins, double budget) {
  StageOptions limited = options();
  limited.budget = budget;
  const SharedMap map = sheet_map();
  EngineStage stage(limited, std::vector(joins < 0 ? 2UL : 1UL, map), {steel});
  std::vector<double> sound;
  for (int step = 0; step < 40; ++step) {
    stage.listen(std::vector<Triple>{{0.1 + 0.01 * std::min(step, 5), 0.3, 0.8}});
    if (step == joins) {
      EXPECT_EQ(stage.add(map), 1U);
    }
    if (step == 0 || step == 20) {
      stage.contact(blow_at(0));
    }
    if (step == 10) {
      stage.contact(blow_at(1));
    }
    if (step >= 10) {
      stage.place(1, {.position = {0.002 * step, 0.0, 0.0}});
    }
    const std::vector<double> more = heard(stage);
    sound.insert(sound.end(), more.begin(), more.end());
  }
  return sound;
}

}  // namespace

TEST(StageJoining, WhoJoinsSoundsAsIfItHadBeenThere) {
  for (const double budget : {std::numeric_limits<double>::infinity(), 0.5, 0.004}) {
    const std::vector<double> expected = two_bodies(-1, budget);
    EXPECT_GT(peak(expected), 1e-3);
    EXPECT_EQ(two_bodies(3, budget), expected) << budget;
    EXPECT_EQ(two_bodies(10, budget), expected) << budget;
  }
}

TEST(StageJoining, WhoLeavesFadesAndOthersGoOn) {
  const SharedMap map = sheet_map();
  EngineStage alone(options(), {map}, {steel}), stage(options(), {map, map}, {steel});
  EngineStage whole(options(), {map, map}, {steel});
  for (EngineStage* one : {&alone, &stage, &whole}) {
    one->contact(blow_at(0));
  }
  for (EngineStage* one : {&stage, &whole}) {
    one->contact(blow_at(1));
    one->place(1, {.position = {0.0, 0.0, 0.3}});
  }
  heard(alone);
  EXPECT_EQ(heard(stage), heard(whole));
  stage.remove(1);
  const std::vector<double> fading = heard(stage, 2), expected = heard(whole, 2), rest = heard(alone, 2);
  EXPECT_LE(steepest(fading), 1.01 * steepest(expected));
  EXPECT_NE(fading, expected);
  EXPECT_NE(fading[200], rest[200]) << "it is heard while it fades";
  EXPECT_EQ(heard(stage, 10), heard(alone, 10)) << "nothing is left of it";
}

TEST(StageJoining, ANumberIsFreeWhenItsBodyHasFaded) {
  const SharedMap map = sheet_map(), other = sheet_map();
  EngineStage stage(options(), {map, map}, {steel});
  stage.contact(blow_at(0));
  heard(stage);
  stage.remove(0);
  EXPECT_EQ(stage.add(other), 2U) << "the first one has not faded";
  EXPECT_EQ(support::error_of([&] { stage.remove(0); }), "there is no body 0");
  EXPECT_EQ(support::error_of([&] { stage.place(0, {}); }), "there is no body 0");
  EXPECT_EQ(support::error_of([&] { stage.contact(blow_at(0)); }), "there is no body 0");
  EXPECT_EQ(support::error_of([&] { stage.add(SharedMap()); }), "a body has no map");
  heard(stage, 5);
  EXPECT_EQ(stage.add(other), 0U);
  stage.contact(blow_at(0));
  EXPECT_GT(peak(heard(stage)), 1e-3) << "the new one sounds";
  stage.remove(0);
  stage.remove(2);
  heard(stage, 6);
  EXPECT_EQ(other.use_count(), 1) << "who has left takes no memory";
}

/// A body leaves while it is scraped and changes of the listener are on their way.
TEST(StageJoining, WhoHasLeftStaysSilent) {
  EngineStage stage(options(0.1), {sheet_map()}, {steel});
  for (int step = 0; step < 20; ++step) {
    ContactEvent event = blow_at(0);
    event.slip = {0.5, 0, 0};
    stage.contact(event);
    stage.place(0, {.position = {0.01 * step, 0, 0}});
    heard(stage);
  }
  stage.remove(0);
  EXPECT_GT(peak(heard(stage)), 0.0);
  heard(stage, 2);
  EXPECT_EQ(peak(heard(stage, 20)), 0.0);
}

TEST(StageJoining, WhatRestedOnABodyThatLeavesIsNotStruck) {
  const SharedMap map = sheet_map();
  EngineStage stage(options(), {map, map}, {steel}), other(options(), {map, map}, {steel});
  for (EngineStage* one : {&stage, &other}) {
    one->place(1, {.position = {0.0, 0.0, 0.3}});
    ContactEvent event = blow_at(0);
    event.bodies = {0, 1};
    for (int step = 0; step < 20; ++step) {
      one->contact(event);
      heard(*one);
    }
    one->contact(event);
  }
  stage.remove(0);
  heard(stage, 5);
  heard(other);  // its contact ends before
  other.remove(0);
  heard(other, 4);
  const std::vector<double> found = heard(stage, 10);
  EXPECT_GT(peak(found), 0.0);
  EXPECT_EQ(found, heard(other, 10));
  EXPECT_EQ(stage.report().impacts, 1U);
}

TEST(StageJoining, AContactThatWaitsStrikesNoOtherBody) {
  const SharedMap map = sheet_map();
  EngineStage stage(options(), {map}, {steel});
  stage.contact(blow_at(0));
  stage.remove(0);
  std::vector<double> block(4096);
  stage.render(block);
  static_cast<void>(stage.report());  // frees what has left
  EXPECT_EQ(stage.add(map), 1U) << "the contact is between the first body and nobody";
}

/// More forces wait for their time than can be on their way to a body.
TEST(StageJoining, FadesAtOnceWhateverWaits) {
  EngineStage stage(options(), {sheet_map()}, {steel});
  stage.contact(blow_at(0));
  heard(stage);
  for (std::uint64_t contact = 1; contact <= 300; ++contact) {
    ContactEvent event = blow_at(0);
    event.contact = contact;
    event.moment = 0.9;
    stage.contact(event);
  }
  stage.remove(0);
  stage.step(1.0);
  std::vector<double> block(2400);
  stage.render(block);
  EXPECT_GT(peak(block), 0.0);
  stage.render(block);
  EXPECT_EQ(peak(block), 0.0);
}

TEST(StageJoining, NeverLocksOrAllocatesInTheAudioThread) {
  StageOptions limited = options();
  limited.budget = 0.1;
  const SharedMap map = sheet_map();
  EngineStage stage(limited, {map}, {steel});
  std::vector<float> block(frames);
  const long before = plugin::AudioThread::offences();
  for (int step = 0; step < 60; ++step) {
    const std::size_t body = stage.add(map);
    stage.contact(blow_at(body));
    stage.step(duration);
    {
      const plugin::AudioThread thread;
      stage.render(block, 1.0);
    }
    stage.remove(body);
  }
  EXPECT_EQ(stage.report().impacts, 60U);
  EXPECT_GT(stage.report().sounding, 0U);
  EXPECT_LT(stage.add(map), 10U) << "numbers are used again";
  EXPECT_EQ(plugin::AudioThread::offences() - before, 0);
}

TEST(StageJoining, GoesOnWhileAnotherThreadRenders) {
  const SharedMap map = sheet_map();
  EngineStage stage(options(), {map}, {steel});
  AudioThread audio(stage);
  std::vector<std::size_t> present;
  bool is_used_again = false;
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < 300 || !audio.sounds() || !is_used_again; ++step) {
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(30)) {
      ADD_FAILURE() << "nothing sounds, or no number is used again";
      break;
    }
    present.push_back(stage.add(map));
    is_used_again = is_used_again || std::ranges::max(present) > present.back();
    stage.contact(blow_at(present.back()));
    stage.step(duration);
    if (present.size() > 8) {
      stage.remove(present.front());
      present.erase(present.begin());
    }
  }
  audio.end();
  EXPECT_TRUE(audio.is_finite());
}

}  // namespace idiophone::engines
