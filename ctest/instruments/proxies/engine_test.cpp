#include "idiophone/instruments/proxies/engine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "engines.hpp"

namespace idiophone::proxies {
namespace {

/// Many bodies, few of which may sound, with all levels of detail.
Engine crowd() {
  Engine engine({.priority = Priority::loudness, .largest_divisor = 4, .most_active = 3, .budget = 6e7});
  std::mt19937 random(7);
  for (std::size_t body = 0; body < 8; ++body) {
    engine.add(cube("cube" + std::to_string(body), 1.0 + 0.1 * static_cast<double>(body)));
  }
  for (int i = 0; i < 40; ++i) {
    const auto body = static_cast<std::size_t>(random() % 8);
    const double impulse = 1e-4 * static_cast<double>(1 + random() % 20);
    engine.add(impact(body, random() % 20000, {0.03, 0.06, 0.1}, {0.0, 0.0, -impulse}, 1e-3, engine_rate));
  }
  for (std::size_t body = 0; body < 8; body += 2) {
    engine.add(Tuning{.body = body, .start = 7013 * static_cast<std::int64_t>(body), .tension = 1.5, .friction = 2.0});
  }
  return engine;
}

TEST(Engine, GivesTheSameBitsForAnyBlocks) {
  std::vector<double> whole(22050), parts(whole.size());
  Engine first = crowd(), second = crowd();
  first.render(whole);
  std::mt19937 random(3);
  for (std::size_t begin = 0; begin < parts.size();) {
    const std::size_t size = std::min<std::size_t>(1 + random() % 700, parts.size() - begin);
    second.render(std::span(parts).subspan(begin, size));
    begin += size;
  }
  EXPECT_EQ(whole, parts);
  EXPECT_NE(whole, std::vector<double>(whole.size()));
  const std::vector<Choice> choices = first.take_choices(), others = second.take_choices();
  ASSERT_EQ(choices.size(), others.size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    EXPECT_EQ(std::tie(choices[i].sample, choices[i].body, choices[i].kind, choices[i].level, choices[i].divisor),
              std::tie(others[i].sample, others[i].body, others[i].kind, others[i].level, others[i].divisor));
  }
}

TEST(Engine, KeepsItsLimits) {
  Engine engine = crowd();
  std::vector<double> block(100);
  double largest = 0.0;
  std::size_t most = 0;
  std::vector<double> costs(8);
  for (int i = 0; i < 220; ++i) {
    engine.render(block);
    most = std::max(most, engine.active());
    for (const Choice& choice : engine.take_choices()) {
      costs[choice.body] = choice.kind == Choice::Kind::begin ? choice.cost : costs[choice.body];
      costs[choice.body] =
          choice.kind == Choice::Kind::end || choice.kind == Choice::Kind::stop ? 0.0 : costs[choice.body];
      largest = std::max(largest, std::accumulate(costs.begin(), costs.end(), 0.0));
    }
  }
  EXPECT_EQ(most, 3);
  EXPECT_LE(largest, 6e7);
  EXPECT_GT(largest, 1e7);
}

TEST(Engine, ImpactHasItsImpulse) {
  for (const double duration : {0.0, 1e-5, 7.3e-4}) {
    const Force force = impact(0, 0, Vector3::Zero(), {0.0, 3e-3, 4e-3}, duration, engine_rate);
    EXPECT_NEAR(std::accumulate(force.curve.begin(), force.curve.end(), 0.0) / engine_rate, 5e-3, 1e-15);
    EXPECT_EQ(force.curve.size(), static_cast<std::size_t>(std::max(1.0, std::ceil(duration * engine_rate))));
  }
}

TEST(Engine, IsSilentUnderAConstantForce) {
  Engine engine({});
  engine.add(cube("cube"));
  engine.add(Force{.body = 0,
                   .start = 0,
                   .at = {0.03, 0.06, 0.1},
                   .direction = -Vector3::UnitZ(),
                   .curve = std::vector<double>(2 * engine_rate, 1.0)});
  std::vector<double> sound(2 * engine_rate);
  engine.render(sound);
  const auto loudest = [&](std::size_t begin, std::size_t end) {
    double most = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      most = std::max(most, std::abs(sound[i]));
    }
    return most;
  };
  // The rounding of single precision leaves about 1e-4, which depends on the compiler's flags.
  EXPECT_LT(loudest(sound.size() - engine_rate / 2, sound.size() - engine_rate / 10), 3e-4 * loudest(0, 2000));
}

TEST(Engine, NearBodyReplacesAFarOne) {
  Engine engine({.most_active = 1});
  engine.add(cube("far", 3.0));
  engine.add(cube("near", 1.0));
  engine.add(tap(0, 0));
  engine.add(tap(1, 500));
  std::vector<double> sound(501);
  engine.render(sound);
  EXPECT_THAT(kinds(engine), testing::ElementsAre(Choice::Kind::begin, Choice::Kind::stop, Choice::Kind::begin));
  EXPECT_EQ(engine.active(), 1);
  engine.add(tap(0, 501));
  engine.render(std::span(sound).first(200));
  // The far one is silent after 2 ms; its new force is left out.
  EXPECT_THAT(kinds(engine), testing::ElementsAre(Choice::Kind::refuse, Choice::Kind::end));
}

TEST(Engine, FadeIsLinearWithin2Milliseconds) {
  Engine alone({.most_active = 1}), replaced({.most_active = 1}), other({.most_active = 1});
  for (Engine* engine : {&alone, &replaced, &other}) {
    engine->add(cube("far", 3.0));
    engine->add(cube("near", 1.0));
  }
  alone.add(tap(0, 0));
  replaced.add(tap(0, 0));
  replaced.add(tap(1, 400));
  other.add(tap(1, 400));
  std::vector<double> whole(600), both(600), second(600);
  alone.render(whole);
  replaced.render(both);
  other.render(second);
  for (int i = 0; i < 600; ++i) {
    const double gain = i < 400 ? 1.0 : std::max(0.0, 1.0 - (i - 400) / (0.002 * engine_rate));
    EXPECT_NEAR(both[i], gain * whole[i] + second[i], 1e-15);
  }
}

TEST(Engine, LevelChangesOnlyWhenStable) {
  Engine engine({.budget = 1.0});
  EXPECT_EQ(engine.add(cube("cube")), 0);
  const double fine = engine.cost(0, 0, 1), coarse = engine.cost(0, 1, 1);
  EXPECT_GT(fine, 4.0 * coarse);
  Engine tight({.most_active = 2, .budget = fine + 0.5 * coarse});
  tight.add(cube("near", 1.0));
  tight.add(cube("far", 2.0));
  tight.add(tap(1, 0));   // nothing else sounds: it gets the fine level
  tight.add(tap(0, 10));  // no room for both: the nearer one replaces it
  tight.add(tap(0, 4000));
  std::vector<double> sound(5000);
  tight.render(sound);
  const std::vector<Choice> choices = tight.take_choices();
  ASSERT_EQ(choices.size(), 4);
  EXPECT_EQ(choices[0].level, 0);
  EXPECT_EQ(choices[1].kind, Choice::Kind::stop);
  EXPECT_EQ(choices[2].kind, Choice::Kind::begin);
  EXPECT_EQ(choices[3].kind, Choice::Kind::end);  // of the faded one; the second tap on the near one changed nothing
}

TEST(Engine, SmallBudgetRefuses) {
  Engine engine({.budget = 1.0});
  engine.add(cube("cube"));
  engine.add(tap(0, 0));
  std::vector<double> sound(100);
  engine.render(sound);
  EXPECT_THAT(kinds(engine), testing::ElementsAre(Choice::Kind::refuse));
  EXPECT_EQ(sound, std::vector<double>(100));
}

TEST(Engine, StableProxiesEnd) {
  Engine engine({.significant_distance = 1e-8});
  engine.add(cube("cube"));
  engine.add(tap(0, 100));
  std::vector<double> sound(std::size_t{4} * engine_rate);
  engine.render(sound);
  EXPECT_EQ(engine.active(), 0);
  EXPECT_THAT(kinds(engine), testing::ElementsAre(Choice::Kind::begin, Choice::Kind::end));
}

TEST(Engine, LowerRatesSoundAlike) {
  constexpr double any = 1e15;
  Engine probe({.largest_divisor = 4});
  probe.add(cube("cube"));
  std::vector<double> energies;
  for (const double budget : {any, 1.01 * probe.cost(0, 0, 4)}) {
    Engine engine({.sound = Sound::deviation, .largest_divisor = 4, .budget = budget});
    engine.add(cube("cube"));
    engine.add(tap(0, 1));
    std::vector<double> sound(2000);
    engine.render(sound);
    EXPECT_EQ(engine.take_choices().front().divisor, budget == any ? 1 : 4);
    energies.push_back(std::inner_product(sound.begin(), sound.end(), sound.begin(), 0.0));
  }
  EXPECT_NEAR(energies[1] / energies[0], 1.0, 0.1);
}

TEST(Engine, EachBodyIsHeardAlone) {
  const auto struck = [] {
    Engine engine({});
    engine.add(cube("near", 1.0));
    engine.add(cube("far", 2.0));
    engine.add(tap(0, 5));
    engine.add(tap(1, 300));
    return engine;
  };
  std::vector<double> sum(1000), each(2000);
  struck().render(sum);
  struck().render_each(each);
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_NEAR(each[i] + each[1000 + i] / 2.0, sum[i], 1e-12 * std::abs(sum[i]) + 1e-18);
  }
  EXPECT_NE(each[1500], 0.0);
}

/// The largest second difference of the sound of a cube that rings and whose listener jumps to another side, or stays.
double roughness(const Vector3& goal) {
  Engine engine({});
  engine.add({.name = "cube", .levels = {rubber_cube(4)}, .listener = {0.05, 0.05, 1.05}});
  engine.add(tap(0, 0));
  std::vector<double> before(4000), after(1000);
  engine.render(before);
  engine.move_listener(0, goal);
  engine.render(after);
  double largest = 0.0;
  for (std::size_t i = 2; i < after.size(); ++i) {
    largest = std::max(largest, std::abs(after[i] - 2.0 * after[i - 1] + after[i - 2]));
  }
  return largest;
}

TEST(Engine, ListenerThatMovesHearsNoClick) {
  const double still = roughness({0.05, 0.05, 1.05});
  EXPECT_GT(still, 0.0);
  for (const Vector3& goal : {Vector3(0.05, 0.05, -0.95), Vector3(1.05, 0.05, 0.05)}) {
    EXPECT_LT(roughness(goal), 3.0 * still);
  }
}

TEST(Engine, RefusesWrongOptionsAndForces) {
  EXPECT_THROW(Engine({.largest_divisor = 3}), std::invalid_argument);
  EXPECT_THROW(Engine({.most_active = 0}), std::invalid_argument);
  Engine engine({});
  EXPECT_THROW(engine.add(tap(0, 0)), std::invalid_argument);
  engine.add(cube("cube"));
  Force wrong = tap(0, 0);
  wrong.curve[0] = NAN;
  EXPECT_THROW(engine.add(wrong), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::proxies
