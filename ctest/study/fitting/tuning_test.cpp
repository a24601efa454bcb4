#include "idiophone/study/fitting/tuning.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
