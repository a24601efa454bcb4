#include "masking_threshold.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace idiophone::voices {

namespace {

constexpr std::size_t bark = MaskingThreshold::bins_in_bark;

double power_of(double level) {
  return 4e-10 * std::pow(10.0, 0.1 * level);
}

double level_at(const MaskingThreshold& threshold, std::size_t bin) {
  return 10.0 * std::log10(threshold.at(bin) / 4e-10);
}

}  // namespace

TEST(MaskingThreshold, KnowsTheCriticalBandRate) {  // the edges of Zwicker's bands 1, 8 and 16 are 100, 920 and 3150 Hz
  EXPECT_NEAR(static_cast<double>(MaskingThreshold::bin_of(100.0)), 1.0 * bark, 1.0);
  EXPECT_NEAR(static_cast<double>(MaskingThreshold::bin_of(920.0)), 8.0 * bark, 1.0);
  EXPECT_NEAR(static_cast<double>(MaskingThreshold::bin_of(3150.0)), 16.0 * bark, 1.0);
  EXPECT_EQ(MaskingThreshold::bin_of(0.0), 0U);
  EXPECT_LT(MaskingThreshold::bin_of(1e6), MaskingThreshold::bins);
}

TEST(MaskingThreshold, FallsOnBothSidesOfATone) {  // of 60 dB at 8 Bark
  MaskingThreshold threshold;
  threshold.add(8 * bark, power_of(60.0));
  const double own = 60.0 - 1.525 - 0.275 * 8.0 - 4.5;
  EXPECT_NEAR(level_at(threshold, 8 * bark), own, 1e-9);
  EXPECT_NEAR(level_at(threshold, 9 * bark), own - 17.0, 1e-9);
  EXPECT_NEAR(level_at(threshold, 11 * bark), own - 17.0 - 2.0 * (17.0 - 0.15 * 60.0), 1e-9);
  EXPECT_NEAR(level_at(threshold, 7 * bark), own - (0.4 * 60.0 + 6.0), 1e-9);
  EXPECT_NEAR(level_at(threshold, 6 * bark), own - (0.4 * 60.0 + 6.0) - 17.0, 1e-9);
  EXPECT_EQ(threshold.at(16 * bark), 0.0);
  EXPECT_EQ(threshold.at(5 * bark), 0.0);
}

TEST(MaskingThreshold, AddsThePowersOfWhatSeveralTonesHide) {
  MaskingThreshold one, two;
  one.add(40, power_of(70.0));
  two.add(40, power_of(70.0));
  two.add(40, power_of(70.0));
  EXPECT_NEAR(two.at(44) / one.at(44), 2.0, 1e-12);
  two.clear();
  EXPECT_EQ(two.at(44), 0.0);
}

TEST(MaskingThreshold, StaysWithinItsBinsAndSlopes) {
  MaskingThreshold threshold;
  for (const double level : {-200.0, 20.0, 100.0, 300.0}) {
    threshold.add(0, power_of(level));
    threshold.add(MaskingThreshold::bins - 1, power_of(level));
  }
  for (std::size_t bin = 0; bin < MaskingThreshold::bins; ++bin) {
    EXPECT_TRUE(std::isfinite(threshold.at(bin)));
    EXPECT_LT(threshold.at(bin), power_of(300.0));
  }
}

}  // namespace idiophone::voices
