// Sound maps that touch each other and what stands around them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "performance.hpp"
#include "sheet_map.hpp"
#include "sound_power.hpp"

namespace idiophone::voices {

using sound_maps::sheet;

namespace {

score::ScoreEvent blow_on(std::size_t body, double speed) {
  return {
      .time = 0.005,
      .body = body,
      .action = score::HammerBlow{.at = {0.1, 0.1, 0.0}, .direction = -Vector3::UnitZ(), .hammer = {0.01, 1e8, speed}}};
}

/// Below a corner of the first body.
score::BodyContact contact_at(double gap) {
  return {.point = {.body = 0, .at = {0.2, 0.2, 0.0}},
          .direction = Vector3::UnitZ(),
          .other = {},
          .mass = {},
          .gap = {.points = {{.time = 0.0, .value = gap}}},
          .elasticity = {.hardness = 1e8, .loss = 0.2}};
}

/// With the second body.
score::BodyContact contact_of_both(double gap) {
  score::BodyContact contact = contact_at(gap);
  contact.other = score::PointOfBody{.body = 1, .at = {0.0, 0.2, 0.0}};
  return contact;
}

score::Score score_of(std::vector<score::ScoreEvent> events, std::vector<score::BodyContact> contacts) {
  score::Score score;
  score.duration = 1.0;
  score.events = std::move(events);
  score.contacts = std::move(contacts);
  return score;
}

std::vector<double> played(const std::vector<sound_maps::SoundMap>& maps, const score::Score& score,
                           std::int64_t block = 512) {
  Performance performance(maps, score, rate);
  return rendered(performance, 6000, block);
}

/// Of two sounds, over that of the first.
double share_of_difference(std::vector<double> one, const std::vector<double>& other) {
  const double whole = power(one);
  for (std::size_t i = 0; i < one.size(); ++i) {
    one[i] -= other[i];
  }
  return power(one) / whole;
}

sound_maps::SoundMap second_sheet() {
  sound_maps::SoundMap map = sheet("second");
  for (double& frequency : map.frequency) {
    frequency *= 1.37;
  }
  return map;
}

}  // namespace

TEST(TouchingVoices, RattleWhenTheyAreStruckHard) {
  const auto effect = [](double speed) {
    const std::vector<double> alone = played({sheet()}, score_of({blow_on(0, speed)}, {}));
    return share_of_difference(alone, played({sheet()}, score_of({blow_on(0, speed)}, {contact_at(2e-6)})));
  };
  EXPECT_LT(effect(1e-3), 1e-9) << "the stop is out of reach";
  EXPECT_GT(effect(1.0), 0.1);
}

TEST(TouchingVoices, GiveTheSameBitsInBlocksOfAnySize) {
  score::BodyContact rivet = contact_at(1e-6);
  rivet.mass = score::LooseMass{.mass = 1e-3, .load = 0.01};
  const score::Score score =
      score_of({blow_on(0, 1.0), blow_on(1, 0.5)}, {contact_of_both(1e-7), contact_at(1e-6), rivet});
  const std::vector<sound_maps::SoundMap> maps = {sheet(), second_sheet(), sheet("third")};
  const std::vector<double> expected = played(maps, score);
  EXPECT_GT(power(expected), 0.0);
  for (const std::int64_t block : {1, 100, 6000}) {
    EXPECT_EQ(played(maps, score, block), expected) << block;
  }
}

TEST(TouchingVoices, SoundTheSameInAnyOrder) {
  const std::vector<double> expected =
      played({sheet(), second_sheet()}, score_of({blow_on(0, 1.0)}, {contact_of_both(1e-7)}));
  score::BodyContact swapped = contact_of_both(1e-7);
  swapped.point.body = 1;
  swapped.other->body = 0;
  const std::vector<double> other = played({second_sheet(), sheet()}, score_of({blow_on(1, 1.0)}, {swapped}));
  EXPECT_LT(share_of_difference(expected, other), 1e-20);
}

TEST(TouchingVoices, SoundByWhatTouchesThem) {
  // The second sheet is heard alone: the first one is silent by itself.
  sound_maps::SoundMap first = sheet();
  for (sound_maps::MapListener& listener : first.listeners) {
    std::ranges::fill(listener.pressure, 0.0);
  }
  const std::vector<sound_maps::SoundMap> maps = {first, second_sheet()};
  EXPECT_EQ(power(played(maps, score_of({blow_on(0, 1.0)}, {contact_of_both(1e-3)}))), 0.0);
  EXPECT_GT(power(played(maps, score_of({blow_on(0, 1.0)}, {contact_of_both(1e-7)}))), 0.0);
}

TEST(TouchingVoices, DoNotTouchWhileTheyMoveTogether) {
  // The gap between equal points of equal bodies that are struck alike never changes.
  const std::vector<sound_maps::SoundMap> maps = {sheet(), sheet("second")};
  const std::vector<score::ScoreEvent> blows = {blow_on(0, 1.0), blow_on(1, 1.0)};
  score::BodyContact contact = contact_at(1e-9);
  contact.other = score::PointOfBody{.body = 1, .at = contact.point.at};
  EXPECT_LT(share_of_difference(played(maps, score_of(blows, {})), played(maps, score_of(blows, {contact}))), 1e-9);
}

TEST(TouchingVoices, AreSilentUntilSomethingHappens) {
  EXPECT_EQ(power(played({sheet()}, score_of({}, {contact_at(1e-6)}))), 0.0);
}

TEST(TouchingVoices, ArePressedOnWithoutAClick) {
  // A preloaded stop changes the sound of a later blow, but is hardly heard itself.
  const double blow = power(played({sheet()}, score_of({blow_on(0, 1.0)}, {contact_at(-1e-7)})));
  EXPECT_LT(power(played({sheet()}, score_of({}, {contact_at(-1e-7)}))), 1e-4 * blow);
}

TEST(TouchingVoices, CantBeTunedOrTouchedEverywhere) {
  const score::Score score = score_of({}, {contact_of_both(1e-6)});
  Performance performance({sheet(), second_sheet(), sheet("third")}, score, rate);
  EXPECT_THROW(performance.stage().require_tunable(1, {.size = 1.1}), std::runtime_error);
  EXPECT_NO_THROW(performance.stage().require_tunable(2, {.size = 1.1}));
  const std::vector<score::BodyContact> many(17, contact_at(1e-6));
  EXPECT_THROW(Performance({sheet()}, score_of({}, many), rate), std::runtime_error);
}

}  // namespace idiophone::voices
