#include "idiophone/air/radiation/absorption.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace idiophone::radiation {
namespace {

/// A row of ISO 9613-2:1996, table 2: what 9613-1 gives at the midband frequencies of octaves, rounded.
struct Row {
  double temperature, humidity;    // degrees Celsius, per cent
  std::array<double, 8> expected;  // dB/km from 63 Hz to 8 kHz
};

constexpr std::array<Row, 6> table = {{{10, 70, {0.1, 0.4, 1.0, 1.9, 3.7, 9.7, 32.8, 117}},
                                       {20, 70, {0.1, 0.3, 1.1, 2.8, 5.0, 9.0, 22.9, 76.6}},
                                       {30, 70, {0.1, 0.3, 1.0, 3.1, 7.4, 12.7, 23.1, 59.3}},
                                       {15, 20, {0.3, 0.6, 1.2, 2.7, 8.2, 28.2, 88.8, 202}},
                                       {15, 50, {0.1, 0.5, 1.2, 2.2, 4.2, 10.8, 36.2, 129}},
                                       {15, 80, {0.1, 0.3, 1.1, 2.4, 4.1, 8.3, 23.7, 82.8}}}};

TEST(Absorption, IsThatOfTheStandardsTable) {
  const double decibels_per_km = 1000.0 * 20.0 / std::log(10.0);
  for (const auto& [temperature, humidity, expected] : table) {
    for (std::size_t octave = 0; octave < expected.size(); ++octave) {
      const double frequency = 1000.0 * std::pow(10.0, 0.3 * (static_cast<double>(octave) - 4.0));
      const double found = decibels_per_km * Atmosphere{temperature, humidity}.attenuation(frequency);
      const double rounding = expected[octave] < 100.0 ? 0.06 : 0.6;
      EXPECT_NEAR(found, expected[octave], rounding) << temperature << " C, " << humidity << " %, " << frequency;
    }
  }
}

TEST(Absorption, IsFiniteInDryAirAndNothingAtRest) {
  EXPECT_EQ((Atmosphere{20, 50}.attenuation(0.0)), 0.0);
  EXPECT_GT((Atmosphere{20, 0}.attenuation(1000.0)), 0.0);
  EXPECT_TRUE(std::isfinite(Atmosphere{-50, 0, 1.0}.attenuation(1e6)));
}

}  // namespace
}  // namespace idiophone::radiation
