#include "idiophone/study/fitting/yield.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bars.hpp"
#include "mode_shapes.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

constexpr double cents_of_e = 1200 / std::numbers::ln2;  // cents of a frequency that is e times as high
constexpr double young = 7e10;                           // Pa
constexpr double density = 2700;                         // kg/m3

/// A bar of a length (m), Young's modulus (Pa) and density (kg/m3).
scene::Scene bar_with(double length, double modulus, double mass) {
  scene::Scene scene = bar_scene({length, 0.02, 0.01}, 0.06, 4);
  scene.materials[0].young = modulus;
  scene.materials[0].density = mass;
  return scene;
}

double frequency_of(double length) {
  const scene::Scene scene = bar_with(length, young, density);
  return mode_shapes(scene::Solids(scene).alone(0), {.count = 1}).frequencies[0];
}

/// Part of a normal distribution below a number of standard deviations.
double normal_part(double deviations) {
  return 0.5 * std::erfc(-deviations / std::numbers::sqrt2);
}

ON_RANKS(1);

TEST(Yield, OfOneNumberIsThatOfANormalDistribution) {
  const Target target{.values = {frequency_of(0.2)}};
  const auto scene_of = [](const std::vector<double>& values) { return bar_with(values[0], young, density); };
  const auto yield = yield_of(scene_of, {{"length", 0.2, 2e-4}}, target, {.modes = {1}, .within = 5});
  ASSERT_TRUE(yield);
  const double effect = yield->effects[0][0];
  EXPECT_NEAR(effect, -2 * cents_of_e * 2e-4 / 0.2, 0.15);  // f ~ 1/length^2, but for shear
  EXPECT_NEAR(yield->deviations[0], std::abs(effect), 0.02);
  EXPECT_NEAR(yield->share, 1 - 2 * normal_part(-5 / std::abs(effect)), 0.004);
}

// The frequency is as the root of Young's modulus, whose parabola is nearer than its tangent.
TEST(Yield, KnowsTheBendOfAnEffect) {
  const Target target{.values = {frequency_of(0.2) * std::exp2(80.0 / 1200)}};  // the mean bar is 80 cents too low
  const auto scene_of = [](const std::vector<double>& values) { return bar_with(0.2, values[0], density); };
  const auto yield = yield_of(scene_of, {{"young", young, 0.1 * young}}, target, {.modes = {1}, .within = 80});
  ASSERT_TRUE(yield);
  const double highest = (std::exp2(160.0 / 600) - 1) / 0.1;  // deviations, at which the bar is 80 cents too high
  EXPECT_NEAR(yield->share, normal_part(highest) - 0.5, 0.005);
}

TEST(Yield, OfRatiosIsThatOfNumbersThatChangeThem) {
  const Target target{.values = {1, 2.6}, .are_ratios = true};
  const auto scene_of = [](const std::vector<double>& values) { return bar_with(values[1], young, values[0]); };
  const auto yield = yield_of(scene_of, {{"density", density, 0.05 * density}, {"length", 0.2, 1e-3}}, target,
                              {.modes = {1, 3}, .within = 5});
  ASSERT_TRUE(yield);
  EXPECT_NEAR(yield->effects[1][0], 0, 1e-6);
  EXPECT_GT(std::abs(yield->effects[1][1]), 0.1);
  EXPECT_EQ(yield->deviations[0], 0);
}

TEST(Yield, IsUnknownWhereTheWatchEndsTheWork) {
  int solves = 0;
  const auto scene_of = [&solves](const std::vector<double>& values) {
    ++solves;
    return bar_with(values[0], young, density);
  };
  const auto watch = [](const SearchState& state) { return state.solves < 2; };
  EXPECT_FALSE(yield_of(scene_of, {{"length", 0.2, 2e-4}}, {.values = {1000}}, {.modes = {1}, .watch = watch}));
  EXPECT_EQ(solves, 2);
}

}  // namespace
}  // namespace idiophone::fitting
