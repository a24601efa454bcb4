#include "idiophone/study/fitting/tuning.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "bars.hpp"
#include "idiophone/study/fitting/deck_numbers.hpp"
#include "long_verification.hpp"
#include "mode_shapes.hpp"
#include "ranks.hpp"
#include "temporary_file.hpp"

namespace idiophone::fitting {
namespace {

/// A bar whose length and width (m) are varied.
scene::Scene bar_with(const std::vector<double>& values) {
  return bar_scene({values[0], values.size() > 1 ? values[1] : 0.02, 0.01}, 0.06, 4);
}

ON_RANKS(1);

TEST(Tune, ALengthForAFrequency) {
  const Target target{.values = {1000}};
  const Tuning found = tune(bar_with, {{"length", 0.12, 0.3, 0.2}}, target, {.modes = {1}, .tolerance = 1});
  EXPECT_TRUE(found.is_tuned);
  EXPECT_NEAR(found.modes[0].frequency, 1000, 0.6);
  EXPECT_GT(found.modes[0].similarity, 0.9);
  EXPECT_EQ(found.modes[0].kind, "bending 1 along z");
  // f ~ 1/length^2, but for shear.
  EXPECT_NEAR(found.sensitivities[0][0] * found.values[0], -2 * 1200 / std::log(2), 150);
}

// Torsion passes bending when the bar gets wide: what was mode 2 is another mode then.
TEST(Tune, ModesAreRecognisedByTheirShapes) {
  const ModeShapes narrow = mode_shapes(bar_with({0.2, 0.013}), {.count = 6});
  const ModeShapes wide = mode_shapes(bar_with({0.2, 0.05}), {.count = 6});
  const Eigen::MatrixXd likeness = similarities(narrow, {0, 1, 2, 3}, wide);
  EXPECT_GT(likeness(0, 0), 0.95);
  const Target target{.values = {1, 2.9}, .are_ratios = true};
  const Tuning found = tune(bar_with, {{"length", 0.15, 0.3, 0.2}, {"width", 0.012, 0.06, 0.014}}, target,
                            {.modes = {1, 2}, .tolerance = 1});
  for (const TunedMode& mode : found.modes) {
    EXPECT_GT(mode.similarity, 0.9) << mode.start_mode;
  }
  EXPECT_TRUE(found.is_tuned);
  EXPECT_NEAR(found.modes[1].frequency / found.modes[0].frequency, 2.9, 0.002);
}

TEST(Tune, SaysWhenTheBoundsDoNotHoldTheTarget) {
  const Target target{.values = {5000}};
  const Tuning found = tune(bar_with, {{"length", 0.19, 0.21, 0.2}}, target, {.modes = {1}, .tolerance = 1});
  EXPECT_FALSE(found.is_tuned);
  EXPECT_NEAR(found.values[0], 0.19, 1e-9);
  EXPECT_EQ(found.bounds[0], Bound::lower);
}

/// A bar that is shorter around a value of 0.1 and still shorter around 0.5.
scene::Scene bar_with_two_dips(const std::vector<double>& values) {
  const auto dip = [&](double middle, double width) { return std::exp(-std::pow((values[0] - middle) / width, 2)); };
  return bar_with({0.2 - 0.02 * dip(0.1, 0.08) - 0.045 * dip(0.5, 0.12)});
}

TEST(Tune, BeginsAgainElsewhereWhereALocalSearchIsStuck) {
  LONG_VERIFICATION();
  const Target target{.values = {2050}};
  const Tuning found = tune(bar_with_two_dips, {{"place", 0.0, 1.0, 0.15}}, target, {.modes = {1}, .tolerance = 1});
  EXPECT_TRUE(found.is_tuned);
  EXPECT_NEAR(found.values[0], 0.5, 0.15);
}

/// A way from 0.1, where the bar is a little shorter, to 0.5 leads past a much shorter bar at 0.3.
TEST(Tune, TellsAnErrorThatNeverRises) {
  const auto scene_of = [](const std::vector<double>& values) {
    const auto dip = [&](double middle, double width) { return std::exp(-std::pow((values[0] - middle) / width, 2)); };
    return bar_with({0.2 - 0.02 * dip(0.1, 0.08) - 0.04 * dip(0.3, 0.05) - 0.005 * values[0]});
  };
  std::vector<double> told;
  const auto watch = [&](const SearchState& state) {
    const std::string before = "best so far: ";  // after the number of the search, if it has one
    told.push_back(std::stod(state.best.substr(state.best.find(before) + before.size())));
    return state.solves < 25;
  };
  const Target target{.values = {2050}};
  static_cast<void>(tune(scene_of, {{"place", 0.0, 1.0, 0.1}}, target, {.modes = {1}, .tolerance = 1, .watch = watch}));
  EXPECT_GT(told.front(), told.back());
  EXPECT_TRUE(std::ranges::is_sorted(told, std::greater())) << ::testing::PrintToString(told);
}

TEST(Tune, StopsWithTheBestValues) {
  const Target target{.values = {1000}};
  const auto watch = [](const SearchState& state) { return state.solves < 4; };
  const Tuning found =
      tune(bar_with, {{"length", 0.12, 0.3, 0.2}}, target, {.modes = {1}, .tolerance = 1e-6, .watch = watch});
  EXPECT_TRUE(found.stopped);
  EXPECT_FALSE(found.is_tuned);
  EXPECT_EQ(found.solves, 4);
  EXPECT_LT(std::abs(found.modes[0].cents), std::abs(1200 * std::log2(found.modes[0].start / 1000)));
  EXPECT_NE(found.values[0], 0.2);
  EXPECT_EQ(found.bounds[0], Bound::none);
}

TEST(Tune, HasTheSensitivitiesOfItsValuesOrNone) {
  const auto stopped_in = [](int solve) {
    const auto watch = [&](const SearchState& state) { return state.solves < solve; };
    return tune(bar_with, {{"length", 0.12, 0.3, 0.2}}, {.values = {1000}},
                {.modes = {1}, .tolerance = 1e-6, .watch = watch});
  };
  for (const int in_a_derivative : {2, 4}) {
    EXPECT_TRUE(std::isnan(stopped_in(in_a_derivative).sensitivities[0][0])) << in_a_derivative;
  }
  for (const int in_a_step : {3, 5}) {
    const Tuning found = stopped_in(in_a_step);
    // f ~ 1/length^2, but for shear.
    EXPECT_NEAR(found.sensitivities[0][0] * found.values[0], -2 * 1200 / std::log(2), 150) << in_a_step;
  }
}

TEST(Tune, TellsThatMoreSearchesFollow) {
  SearchState last;
  const auto watch = [&](const SearchState& state) {
    last = state;
    return state.best.find("search 2 of at most 3") == std::string::npos;
  };
  const Tuning found = tune(bar_with, {{"length", 0.15, 0.2, 0.2}}, {.values = {20}}, {.modes = {1}, .watch = watch});
  EXPECT_TRUE(found.stopped) << last.best;
  EXPECT_GT(last.expected, last.solves + 20) << "two searches of some twelve solves each";
}

/// A bar whose length (m) and viscosity (stiffness damping, s) are varied.
scene::Scene damped_bar(const std::vector<double>& values) {
  scene::Scene scene = bar_with({values[0]});
  scene.materials[0].damping.stiffness = values[1];
  return scene;
}

/// T60 by such a damping: the amplitude falls by exp(-stiffness w^2/2 t), whatever the shape.
double decay_time(double stiffness, double frequency) {
  return 2 * std::log(1000.0) / (stiffness * std::pow(2 * std::numbers::pi * frequency, 2));
}

const std::vector<Variable> length_and_stiffness = {{"length", 0.12, 0.3, 0.2}, {"stiffness", 1e-7, 3e-6, 1e-6}};

TEST(Tune, ADecayTimeTogetherWithAFrequency) {
  const Target target{.values = {1000}};
  const Tuning found = tune(damped_bar, length_and_stiffness, target,
                            {.modes = {1}, .tolerance = 1, .decays = {{1, 0.3}}, .decay_tolerance = 1});
  ASSERT_TRUE(found.is_tuned);
  EXPECT_NEAR(found.modes[0].frequency, 1000, 0.6);
  EXPECT_NEAR(decay_time(found.values[1], 1000) / 0.3, 1, 0.011);
  ASSERT_EQ(found.decays.size(), 1U);
  EXPECT_NEAR(found.decays[0].decay_time / 0.3, 1, 0.01);
  EXPECT_NEAR(found.decays[0].start, decay_time(1e-6, found.modes[0].start), 1e-6 * found.decays[0].start);
  EXPECT_NEAR(found.decays[0].sensitivities[1] * found.values[1], -100, 10) << "T60 ~ 1/stiffness";
}

// Mode 2 bends the bar the other way.
TEST(Tune, TheDecayTimeOfAModeWhosePitchIsFree) {
  const Target target{.values = {1000}};
  const Tuning found = tune(damped_bar, length_and_stiffness, target,
                            {.modes = {1}, .tolerance = 1, .decays = {{2, 0.1}}, .decay_tolerance = 1});
  ASSERT_TRUE(found.is_tuned);
  ASSERT_EQ(found.modes.size(), 1U);
  const ModeShapes shapes = mode_shapes(damped_bar(found.values), {.count = 4});
  const double frequency = shapes.frequencies[found.decays[0].mode - 1];
  EXPECT_GT(frequency, 1500);
  EXPECT_NEAR(decay_time(found.values[1], frequency) / 0.1, 1, 0.01);
}

TEST(Tune, RefusesADecayTimeThatNothingGives) {
  EXPECT_THAT(
      [] {
        static_cast<void>(
            tune(bar_with, {{"length", 0.12, 0.3, 0.2}}, {.values = {1000}}, {.modes = {1}, .decays = {{1, 1.0}}}));
      },
      ::testing::ThrowsMessage<std::runtime_error>(::testing::HasSubstr("nothing damps it")));
}

TEST(Tune, KeepsABandFreeOfModes) {
  LONG_VERIFICATION();
  const Target target{.values = {1000}};
  const std::vector<Variable> sides = {{"length", 0.12, 0.3, 0.226}, {"width", 0.014, 0.03, 0.02}};
  const auto frequencies = [](const Tuning& found) {
    return mode_shapes(bar_with(found.values), {.count = 8}).frequencies;
  };
  const Tuning alone = tune(bar_with, sides, target, {.modes = {1}, .tolerance = 1});
  ASSERT_TRUE(alone.is_tuned);
  EXPECT_TRUE(alone.avoided.empty());
  const double second = frequencies(alone)[1];
  const Band band{0.97 * second, 1.04 * second};
  const Tuning found = tune(bar_with, sides, target, {.modes = {1}, .tolerance = 1, .avoided = {band}});
  EXPECT_TRUE(found.is_tuned);
  EXPECT_NEAR(found.modes[0].frequency, 1000, 0.6);
  EXPECT_THAT(frequencies(found),
              ::testing::Each(::testing::AnyOf(::testing::Lt(band.lower), ::testing::Gt(band.upper))));
  ASSERT_EQ(found.avoided.size(), 1U);
  EXPECT_TRUE(found.avoided[0].modes.empty());
}

TEST(Tune, SaysWhatIsInABandThatItCanNotKeepFree) {
  const Target any_pitch{.values = {1}, .are_ratios = true};
  const Tuning found = tune(bar_with, {{"length", 0.225, 0.227, 0.226}}, any_pitch,
                            {.modes = {1}, .tolerance = 30, .avoided = {{900, 1100}}});
  EXPECT_FALSE(found.is_tuned);
  ASSERT_EQ(found.avoided[0].modes.size(), 1U);
  EXPECT_EQ(found.avoided[0].modes[0], 1);
  EXPECT_NEAR(found.avoided[0].frequencies[0], found.modes[0].frequency, 1e-9);
}

TEST(Tune, RefusesAFrequencyThatIsWantedAndAvoided) {
  EXPECT_THAT(
      [] {
        static_cast<void>(
            tune(bar_with, {{"length", 0.12, 0.3, 0.2}}, {.values = {1000}}, {.modes = {1}, .avoided = {{990, 1050}}}));
      },
      ::testing::ThrowsMessage<std::runtime_error>(::testing::HasSubstr("990 to 1050 Hz is to be avoided")));
}

TEST(Tune, ASimilarityOfOneForTheSameShape) {
  const ModeShapes shapes = mode_shapes(bar_with({0.2, 0.013}), {.count = 4});
  const Eigen::MatrixXd likeness = similarities(shapes, {0, 1, 2, 3}, shapes);
  EXPECT_NEAR((likeness - Eigen::MatrixXd::Identity(4, 4)).cwiseAbs().maxCoeff(), 0, 0.2);
  EXPECT_NEAR((likeness.diagonal().array() - 1).abs().maxCoeff(), 0, 1e-12);
}

TEST(DeckNumbers, AreReadAndReplacedInTheirPlaces) {
  const support::TemporaryFile file("numbers.yaml", "a: {b: 1.5, c: 2}  # a comment\nd: [3, 4]\n");
  const auto& path = file.path();
  EXPECT_EQ(number_at(path, {}, "a.b"), 1.5);
  EXPECT_EQ(number_at(path, {"a.b=7"}, "a.b"), 7);
  EXPECT_EQ(number_at(path, {}, "d.1"), 4);
  EXPECT_EQ(with_numbers(path, {{"a.b", 0.25}, {"a.c", 12345}, {"d.1", -1}}),
            "a: {b: 0.25, c: 12345}  # a comment\nd: [3, -1]\n");
  EXPECT_THROW(static_cast<void>(number_at(path, {}, "a.x")), std::runtime_error);
  EXPECT_THROW(static_cast<void>(number_at(path, {}, "a")), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::fitting
