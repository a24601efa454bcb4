#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

using Shape = Signal::Shape;

constexpr double forever = std::numeric_limits<double>::infinity();

TEST(Signal, HalfSineRisesAndFallsOnce) {
  const Signal pulse{.shape = Shape::half_sine, .start = 0.5, .duration = 2.0, .table = {}};
  EXPECT_EQ(pulse.at(0.499), 0.0);
  EXPECT_EQ(pulse.at(0.5), 0.0);
  EXPECT_DOUBLE_EQ(pulse.at(1.0), std::numbers::sqrt2 / 2.0);
  EXPECT_DOUBLE_EQ(pulse.at(1.5), 1.0);
  EXPECT_EQ(pulse.at(2.5), 0.0);
  EXPECT_EQ(pulse.at(100.0), 0.0);
}

TEST(Signal, ConstantIsOneUntilItEnds) {
  const Signal step{.shape = Shape::constant, .start = 1.0, .duration = 2.0, .table = {}};
  EXPECT_EQ(step.at(0.999), 0.0);
  EXPECT_EQ(step.at(1.0), 1.0);
  EXPECT_EQ(step.at(2.999), 1.0);
  EXPECT_EQ(step.at(3.0), 0.0);
  const Signal endless{.shape = Shape::constant, .duration = forever, .table = {}};
  EXPECT_EQ(endless.at(1e9), 1.0);
}

TEST(Signal, SineKeepsItsFrequency) {
  const Signal tone{.shape = Shape::sine, .start = 0.1, .duration = forever, .frequency = 250.0, .table = {}};
  EXPECT_EQ(tone.at(0.05), 0.0);
  EXPECT_NEAR(tone.at(0.101), 1.0, 1e-12);   // a quarter of its period
  EXPECT_NEAR(tone.at(0.103), -1.0, 1e-12);  // three quarters
  EXPECT_NEAR(tone.at(0.104), 0.0, 1e-12);
}

TEST(Signal, TableIsLinearBetweenItsRowsAndZeroOutside) {
  const Signal table{
      .shape = Shape::table, .start = 10.0, .duration = forever, .table = {{{1.0, 2.0}}, {{2.0, 4.0}}, {{4.0, -4.0}}}};
  EXPECT_EQ(table.at(10.999), 0.0);
  EXPECT_EQ(table.at(11.0), 2.0);
  EXPECT_DOUBLE_EQ(table.at(11.25), 2.5);
  EXPECT_EQ(table.at(12.0), 4.0);
  EXPECT_DOUBLE_EQ(table.at(13.5), -2.0);
  EXPECT_EQ(table.at(14.0), -4.0);
  EXPECT_EQ(table.at(14.001), 0.0);
  EXPECT_EQ((Signal{.shape = Shape::table, .table = {}}.at(1.0)), 0.0);
}

}  // namespace idiophone::scene
