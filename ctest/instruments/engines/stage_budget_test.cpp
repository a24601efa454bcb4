// What a stage leaves out so that contacts keep within the budget.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "map_loudness.hpp"
#include "moving_body.hpp"
#include "shared_folder.hpp"
#include "sheet_stage.hpp"
#include "struck_bodies.hpp"

namespace idiophone::engines {

namespace {

constexpr double small_budget = 0.028;  // three struck sheets have room in its half

EngineStage sheets(std::size_t count, double budget) {
  StageOptions limited = options();
  limited.budget = budget;
  return EngineStage(limited, std::vector(count, sheet_map()), {steel});
}

/// On a body; each of them is quieter than the one before.
ContactEvent blow_on(int body) {
  ContactEvent event = blow();
  event.contact = static_cast<std::uint64_t>(body);
  event.bodies = {body, ContactEvent::nobody};
  event.impulse /= 1.0 + body;
  return event;
}

}  // namespace

TEST(StruckBodies, TheLoudestHaveRoomUntilTheyHaveFaded) {
  constexpr std::int64_t begin = 10000, fade = 2048;  // audio samples
  StruckBodies struck(2.5);
  for (std::size_t body = 0; body < 4; ++body) {
    struck.join(body, 1.0);
  }
  constexpr double none = -1.0;
  const auto chosen = [&](const std::vector<double>& loudness, std::int64_t start) {
    return struck.choose(loudness, start);
  };
  EXPECT_EQ(chosen({1.0, 3.0, none, 2.0}, begin), (std::vector{false, true, false, true}));
  struck.act(1, begin + 500);
  struck.act(3, begin + 700);
  EXPECT_EQ(chosen({1.0, 0.1, none, none}, begin + 600), (std::vector{false, true, false, false}))
      << "its own sound takes no room";
  EXPECT_EQ(chosen({none, none, 2.5, none}, begin + 600)[2], true) << "louder than one of the two";
  EXPECT_EQ(chosen({1.0, none, none, none}, begin + 2000)[0], false);
  EXPECT_EQ(chosen({1.0, none, none, none}, begin + 500 + fade)[0], false) << "what was struck still fades";
  EXPECT_EQ(chosen({1.0, none, none, none}, begin + 700 + fade)[0], true);
}

TEST(StruckBodies, OneHasRoomWhateverItCosts) {
  StruckBodies struck(0.5);
  struck.join(0, 1.0);
  struck.join(1, 1.0);
  EXPECT_EQ(struck.choose(std::vector{0.0, 1.0}, 0), (std::vector{false, true}));
  EXPECT_EQ(struck.choose(std::vector{0.0, -1.0}, 100000), (std::vector{true, false})) << "silent, and alone";
}

TEST(StageBudget, OfManyBlowsTheLoudestAreHeard) {
  EngineStage limited = sheets(8, small_budget), three = sheets(8, std::numeric_limits<double>::infinity());
  for (const int body : {7, 3, 1, 5, 0, 2, 4, 6}) {
    limited.contact(blow_on(body));
  }
  for (const int body : {0, 1, 2}) {
    three.contact(blow_on(body));
  }
  EXPECT_EQ(heard(limited), heard(three));
  EXPECT_EQ(limited.report().left_out, 5);
}

TEST(StageBudget, HoldsWhileEverythingIsStruck) {
  EngineStage stage = sheets(20, small_budget);
  for (int step = 0; step < 20; ++step) {
    for (int body = 0; body < 20; ++body) {
      ContactEvent event = blow_on((body + step) % 20);
      event.contact += static_cast<std::uint64_t>(100 * step);  // or it would be a load
      stage.contact(event);
    }
    heard(stage);
    EXPECT_LE(stage.report().cost, small_budget) << step;
  }
  EXPECT_GT(stage.report().sounding, 0);
}

/// What a body of a stage costs that moves along, or stays, on a machine of some speed.
double cost_of_ringing(double motion, double speed) {
  StageOptions told = options();
  told.budget = 1e9;
  told.speed = speed;
  EngineStage stage(told, {sheet_map()}, {steel});
  stage.contact(blow());
  for (int step = 0; step < 10; ++step) {
    stage.place(0, {.position = {motion * step, 0, 0}});
    heard(stage);
  }
  return stage.report().cost;
}

TEST(StageBudget, ABodyThatMovesCostsMore) {
  EXPECT_GT(cost_of_ringing(0.0, 1.0), 0.0);
  EXPECT_GT(cost_of_ringing(0.01, 1.0), 1.2 * cost_of_ringing(0.0, 1.0));
}

TEST(StageBudget, AFastMachineHasMoreRoom) {
  EXPECT_NEAR(cost_of_ringing(0.01, 4.0), cost_of_ringing(0.01, 1.0) / 4.0, 1e-12);
  EXPECT_NEAR(std::log(measured_speed() / measured_speed()), 0.0, std::log(4.0)) << "of the same machine";
  EXPECT_NEAR(std::log(measured_speed()), 0.0, std::log(30.0)) << "of a machine of our time";
  StageOptions wrong = options();
  wrong.speed = 0.0;
  EXPECT_EQ(support::error_of([&] { EngineStage(wrong, {sheet_map()}, {steel}); }),
            "the speed of the machine has to be from 0.001 to 1000");
}

TEST(StageBudget, LimitsStrokes) {
  const auto strokes = [](double budget) {
    EngineStage stage = sheets(12, budget);
    for (int body = 0; body < 12; ++body) {
      ContactEvent event = blow_on(body);
      event.slip = {0.5, 0, 0};
      stage.contact(event);
    }
    stage.step(duration);
    for (int body = 0; body < 12; ++body) {
      ContactEvent event = blow_on(body);
      event.slip = {0.5, 0, 0};
      stage.contact(event);
    }
    stage.step(duration);
    return stage.report().strokes;
  };
  EXPECT_EQ(strokes(std::numeric_limits<double>::infinity()), 12);
  EXPECT_LT(strokes(0.1), 12);
  EXPECT_GT(strokes(0.1), 0);
}

/// One mode that moves as a whole along z and radiates alike in all directions.
TEST(MapLoudness, IsThatOfAnImpulseInAnyDirection) {
  sound_maps::SoundMap map;
  map.frequency = {100.0};
  map.vertices = {{0, 0, 0}, {1, 0, 0}};
  map.shape = {0.0F, 0.0F, 3.0F, 0.0F, 0.0F, 3.0F};
  map.sphere.distance = 2.0;
  map.sphere.direction = {Vector3::UnitX(), Vector3::UnitZ()};
  map.sphere.pressure = {{0.0, 5.0}, {3.0, 4.0}};
  const double velocity = 3.0 / std::sqrt(3.0), amplitude = 2.0 * 5.0;
  EXPECT_NEAR(loudness_of(map), velocity * amplitude / std::sqrt(2.0), 1e-12);
}

/// The listener of a body that nobody hears need not be exact.
TEST(MovingBody, OfAnUnheardBodyOnlyLargeMotionsAreTold) {
  const std::vector<Vector3> ears = {{0.1, 0.1, 1.0}};
  MovingBody body(*sheet_map(), 1.0, ears, rate);
  body.sound_until(1000);
  body.place({.position = {0, 0, 0.001}});
  EXPECT_FALSE(body.follow(ears, 0, frames, MovingBody::Part::unheard));
  EXPECT_TRUE(body.follow(ears, 0, frames, MovingBody::Part::heard));
  EXPECT_FALSE(body.follow(ears, 0, frames, MovingBody::Part::heard)) << "it has not moved since";
  body.place({.position = {0, 0, 0.03}});
  EXPECT_TRUE(body.follow(ears, 0, frames, MovingBody::Part::unheard));
}

}  // namespace idiophone::engines
