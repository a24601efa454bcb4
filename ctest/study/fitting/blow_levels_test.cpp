// How loud the blows of a deck are, and bodies that are tuned to that.

#include "blow_levels.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "bars.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/study/fitting/tuning.hpp"
#include "mode_shapes.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A bar that a force (N) strikes near an end, heard half a metre above it.
/// @param thickness  m
scene::Scene struck_bar(double force, double thickness = 0.01) {
  scene::Scene scene = bar_scene({0.2, 0.03, thickness}, 0.1, 3);
  scene.deck = "bar.yaml";
  scene.materials[0].damping.mass = 20;
  scene.bodies[0].where = {"bar.yaml", 4, 3};
  scene.time.duration = 0.5;
  scene.audio.max_frequency = 2000;
  scene::Listener& listener = scene.listeners.emplace_back();
  listener.receivers.push_back({.channel = "ear", .position = {0.1, 0, 0.5}});
  scene::ForcePulse& tap = scene.pulses.emplace_back();
  tap.name = "tap";
  tap.place.at = {0.02, 0, thickness / 2};
  tap.force = {0, 0, -force};
  tap.signal.duration = 2e-4;
  return scene;
}

double level_of(const scene::Scene& scene) {
  return blow_levels(scene, "", {"ear"}, sound_maps::solve_solid(scene, 0, {.up_to = scene.audio.max_frequency}))
      .front();
}

/// A search for the force of a blow that makes the bar's first mode no other.
Tuning tuned_to(const WantedLevel& wanted, double largest_force) {
  const scene::Scene start = struck_bar(10);
  const Target target{.values = {mode_shapes(scene::Solids(start).alone(0), {.count = 1}).frequencies[0]}};
  return tune([](const std::vector<double>& values) { return struck_bar(values[0]); },
              {{"loads.tap.force", 1, largest_force, 10}}, target, {.modes = {1}, .levels = {wanted}});
}

ON_RANKS(1);

TEST(BlowLevels, AreThoseOfForces) {
  const double once = level_of(struck_bar(10));
  EXPECT_NEAR(level_of(struck_bar(20)) - once, 20 * std::log10(2), 1e-9);
  scene::Scene twice = struck_bar(10);
  twice.pulses.push_back(twice.pulses[0]);
  EXPECT_NEAR(level_of(twice) - once, 20 * std::log10(2), 1e-9) << "forces add up";
  scene::Scene far = struck_bar(10);
  far.listeners[0].receivers[0].position = {0.1, 0, 5};
  scene::Scene farther = struck_bar(10);
  farther.listeners[0].receivers[0].position = {0.1, 0, 10};
  EXPECT_NEAR(level_of(far) - level_of(farther), 20 * std::log10(2), 0.1);
}

TEST(BlowLevels, NeedAForceAndAListener) {
  scene::Scene silent = struck_bar(10);
  silent.pulses.clear();
  EXPECT_THAT([&] { level_of(silent); },
              ::testing::ThrowsMessage<deck::DeckError>(StartsWith("bar.yaml:4:3: no load strikes body bar")));
  scene::Scene bowed = struck_bar(10);
  bowed.bows.emplace_back().name = "bow";
  EXPECT_THAT([&] { level_of(bowed); }, ::testing::ThrowsMessage<deck::DeckError>(HasSubstr("load bow is no force")));
  scene::Scene deaf = struck_bar(10);
  deaf.listeners[0].receivers[0].channel = "eat";
  EXPECT_THAT([&] { level_of(deaf); }, ::testing::ThrowsMessage<std::runtime_error>(
                                           HasSubstr("no listener is called 'ear' (did you mean 'eat'?)")));
}

TEST(TunedLevels, AreReached) {
  const double start = level_of(struck_bar(10));
  const Tuning found = tuned_to({.listener = "ear", .level = start + 6}, 100);
  EXPECT_TRUE(found.is_tuned);
  ASSERT_EQ(found.levels.size(), 1U);
  EXPECT_NEAR(found.levels[0].start, start, 1e-9);
  EXPECT_NEAR(found.levels[0].level, level_of(struck_bar(found.values[0])), 1e-9);
  EXPECT_NEAR(found.levels[0].level, start + 6, 0.1);
  EXPECT_NEAR(found.levels[0].sensitivities[0] * found.values[0], 20 / std::log(10), 0.5);
}

TEST(TunedLevels, KeepLimits) {
  const double start = level_of(struck_bar(10));
  const Tuning quieter = tuned_to({.listener = "ear", .kind = WantedLevel::Kind::at_most, .level = start - 3}, 100);
  EXPECT_TRUE(quieter.is_tuned);
  EXPECT_LE(quieter.levels[0].level, start - 3);
  const Tuning content = tuned_to({.listener = "ear", .kind = WantedLevel::Kind::at_least, .level = start - 3}, 100);
  EXPECT_TRUE(content.is_tuned);
  EXPECT_EQ(content.values[0], 10) << "it is loud enough";
}

TEST(TunedLevels, AreNamedWhereTheyAreOutOfReach) {
  const double start = level_of(struck_bar(10));
  const Tuning found = tuned_to({.listener = "ear", .kind = WantedLevel::Kind::at_least, .level = start + 20}, 20);
  EXPECT_FALSE(found.is_tuned);
  EXPECT_FALSE(found.levels[0].is_reached);
  EXPECT_EQ(found.bounds[0], Bound::upper);
  EXPECT_NEAR(found.levels[0].level, start + 20 * std::log10(2), 1e-6);
}

}  // namespace
}  // namespace idiophone::fitting
