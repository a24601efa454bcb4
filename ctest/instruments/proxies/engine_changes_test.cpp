// What changes while an engine sounds: levels, priorities, limits, and the tuning of bodies.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "engines.hpp"

namespace idiophone::proxies {
namespace {

/// Sound of one body that is tuned when it is struck.
std::vector<double> tuned_sound(const std::shared_ptr<const Lattice>& lattice, const Tuning& tuning,
                                std::int64_t tuned_at = 0) {
  Engine engine({});
  const double size = lattice->mesh().nodes.back()[0];  // of a cube from the origin
  engine.add({.name = "cube", .levels = {lattice}, .listener = lattice->inertia().centre + Vector3(0.0, 0.0, 1.0)});
  Tuning at_its_time = tuning;
  at_its_time.start = tuned_at;
  engine.add(at_its_time);
  engine.add(impact(0, 0, {0.3 * size, 0.6 * size, size}, {0.0, 0.0, -1e-3}, 5e-4, engine_rate));
  std::vector<double> sound(2000);
  engine.render(sound);
  return sound;
}

void expect_alike(const std::vector<double>& found, const std::vector<double>& expected) {
  double difference = 0.0, power = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    difference += std::pow(found[i] - expected[i], 2);
    power += std::pow(expected[i], 2);
  }
  EXPECT_GT(power, 0.0);
  EXPECT_LT(std::sqrt(difference / power), 1e-3);
}

TEST(Engine, ARemovedBodyFadesAndItsNumberIsUsedAgain) {
  Engine engine({.most_active = 2}), whole({.most_active = 2});
  for (Engine* one : {&engine, &whole}) {
    one->add(cube("first"));
    one->add(tap(0, 0));
    one->add(tap(0, 3000));
  }
  std::vector<double> sound(1000), expected(1000);
  engine.render(sound);
  whole.render(expected);
  EXPECT_EQ(sound, expected);
  engine.remove(0);
  EXPECT_TRUE(engine.sounds(0));
  EXPECT_EQ(engine.add(cube("second")), 1U) << "the first one has not faded";
  engine.render(sound);
  whole.render(expected);
  EXPECT_NEAR(sound[20], (1.0 - 20.0 / (0.002 * engine_rate)) * expected[20], 1e-12);
  EXPECT_EQ(std::vector<double>(sound.begin() + 100, sound.end()), std::vector<double>(900, 0.0));
  EXPECT_FALSE(engine.sounds(0));
  EXPECT_EQ(engine.add(cube("third")), 0U);
  EXPECT_EQ(engine.body(0).name, "third");
  engine.render(sound);
  engine.render(sound);
  EXPECT_EQ(sound, std::vector<double>(1000, 0.0)) << "the second blow was meant for the first one";
  engine.add(tap(0, engine.now()));
  engine.render(sound);
  Engine fresh({});
  fresh.add(cube("third"));
  fresh.add(tap(0, 0));
  fresh.render(expected);
  EXPECT_EQ(sound, expected);
  EXPECT_THROW(engine.remove(2), std::invalid_argument);
}

TEST(Engine, WithoutBodiesRendersSilence) {
  Engine engine({});
  std::vector<double> sound(300, 1.0);
  engine.render_each(sound);
  EXPECT_EQ(sound, std::vector<double>(300, 0.0));
  EXPECT_EQ(engine.now(), 300);
}

TEST(Engine, LevelsAndPrioritiesCanBeSet) {
  Engine engine({.significant_distance = 1e-7, .priority = Priority::fixed, .most_active = 1});
  engine.add(cube("first"));
  engine.add(cube("second"));
  engine.set_level(1, 1);
  engine.set_priority(1, 2.0);
  engine.add(tap(0, 0));
  engine.add(tap(1, 100));
  std::vector<double> sound(150);
  engine.render(sound);
  const std::vector<Choice> choices = engine.take_choices();
  ASSERT_EQ(choices.size(), 3U);
  EXPECT_EQ(choices[1].kind, Choice::Kind::stop);
  EXPECT_EQ(choices[2].body, 1U);
  EXPECT_EQ(choices[2].level, 1U);
  EXPECT_THROW(engine.set_level(0, 2), std::invalid_argument);
  EXPECT_THROW(engine.set_level(2, 0), std::invalid_argument);
  EXPECT_THROW(engine.set_priority(0, NAN), std::invalid_argument);
  engine.set_level(1, std::nullopt);
  std::vector<double> rest(200000);
  engine.render(rest);
  engine.add(tap(1, 0));
  engine.render(sound);
  EXPECT_EQ(engine.take_choices().back().level, 0U);
}

TEST(Engine, ApplicationDecidesPriorities) {
  std::vector<PriorityQuestion> asked;
  Engine engine({.priority_of =
                     [&](const PriorityQuestion& question) {
                       asked.push_back(question);
                       return static_cast<double>(question.body);
                     },
                 .most_active = 1});
  engine.add(cube("near", 1.0));
  engine.add(cube("far", 3.0));
  engine.add(tap(0, 0));
  engine.add(tap(1, 100));
  std::vector<double> sound(150);
  engine.render(sound);
  EXPECT_THAT(kinds(engine), testing::ElementsAre(Choice::Kind::begin, Choice::Kind::stop, Choice::Kind::begin));
  ASSERT_FALSE(asked.empty());
  EXPECT_NEAR(asked.front().distance, 1.0, 0.01);
  EXPECT_NEAR(asked.front().strength, 1e-3 / rubber_cube(4)->inertia().mass, 1e-6);
}

TEST(Engine, LimitsCanChange) {
  Engine engine({.most_active = 3});
  for (int body = 0; body < 3; ++body) {
    engine.add(cube("cube", 1.0 + body));
    engine.add(tap(static_cast<std::size_t>(body), 0));
  }
  std::vector<double> sound(200);
  engine.render(sound);
  EXPECT_EQ(engine.active(), 3U);
  engine.set_limits(1e15, 2);
  EXPECT_EQ(engine.active(), 2U);
  engine.set_limits(1.01 * engine.cost(0, 0, 1), 2);
  EXPECT_EQ(engine.active(), 1U);
  engine.render(sound);
  const std::vector<Choice> choices = engine.take_choices();
  EXPECT_EQ(choices[3].kind, Choice::Kind::stop);
  EXPECT_EQ(choices[3].body, 2U);  // the farthest
  EXPECT_THROW(engine.set_limits(0.0, 2), std::invalid_argument);
}

TEST(Engine, BodiesBehindTheListenerComeLast) {
  for (const double behind : {1.0, 0.1}) {
    Engine engine({.behind = behind, .most_active = 1});
    engine.add(cube("behind", 1.0));
    engine.add(cube("ahead", 2.0));
    engine.move_listener(0, {0.05, 0.05, 1.05}, Vector3::UnitZ());
    engine.move_listener(1, {0.05, 0.05, 2.05}, -Vector3::UnitZ());
    engine.add(tap(0, 0));
    engine.add(tap(1, 100));
    std::vector<double> sound(200);
    engine.render(sound);
    EXPECT_EQ(engine.take_choices()[1].kind, behind < 1.0 ? Choice::Kind::stop : Choice::Kind::refuse);
  }
  EXPECT_THROW(Engine({.behind = 0.0}), std::invalid_argument);
}

TEST(Engine, TensionIsAStifferMaterial) {
  const Material stiffer{.young = 4.0 * rubber.young, .density = rubber.density, .damping = rubber.damping};
  const auto other = std::make_shared<Lattice>(box({0.1, 0.1, 0.1}, {4, 4, 4}, 0.2), stiffer);
  expect_alike(tuned_sound(rubber_cube(4), {.tension = 4.0}), tuned_sound(other, {}));
}

TEST(Engine, SizeIsALargerBody) {
  expect_alike(tuned_sound(rubber_cube(4), {.size = 2.0}), tuned_sound(rubber_cube(4, 0.2), {}));
}

TEST(Engine, FrictionChangesWhatSounds) {
  const std::vector<double> kept = tuned_sound(rubber_cube(4), {}),
                            damped = tuned_sound(rubber_cube(4), {.friction = 20.0}, 1000);
  EXPECT_TRUE(std::equal(kept.begin(), kept.begin() + 1000, damped.begin()));
  const auto late_energy = [](const std::vector<double>& sound) {
    return std::inner_product(sound.begin() + 1500, sound.end(), sound.begin() + 1500, 0.0);
  };
  EXPECT_LT(late_energy(damped), 0.5 * late_energy(kept));
  EXPECT_GT(late_energy(damped), 0.0);
}

TEST(Engine, RefusesWrongTunings) {
  Engine engine({});
  EXPECT_THROW(engine.add(Tuning{}), std::invalid_argument);
  engine.add(cube("cube"));
  EXPECT_THROW(engine.add(Tuning{.tension = 0.0}), std::invalid_argument);
  EXPECT_THROW(engine.add(Tuning{.friction = -1.0}), std::invalid_argument);
  EXPECT_THROW(engine.add(Tuning{.tension = 1e30}), std::invalid_argument);
  EXPECT_THROW(engine.add(Tuning{.size = NAN}), std::invalid_argument);
}

}  // namespace
TEST(Engine, OthersTakeTheirPartOfTheBudget) {
  double taken = 0.0;  // with a priority of 0.5
  Engine engine({.budget = 1e9, .others = [&](double priority) { return priority <= 0.5 ? taken : 0.0; }});
  engine.add(cube("far", 3.0));
  engine.add(cube("near", 1.0));
  for (const std::size_t body : {0U, 1U}) {
    engine.add(impact(body, 0, {0.03, 0.06, 0.1}, {0.0, 0.0, -1e-3}, 1e-3, engine_rate));
  }
  std::vector<double> sound(100);
  engine.render(sound);
  ASSERT_EQ(engine.shares().size(), 2U);
  EXPECT_NEAR(engine.shares().back().priority, 1.0, 0.1);
  taken = 1e9;
  engine.keep_limits();
  EXPECT_EQ(engine.shares().size(), 1U);
  EXPECT_NEAR(engine.shares().front().priority, 1.0, 0.1);
  EXPECT_EQ(engine.active(), 1U);
}

}  // namespace idiophone::proxies
