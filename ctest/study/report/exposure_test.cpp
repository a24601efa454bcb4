#include "exposure.hpp"

#include <gtest/gtest.h>

#include "blows.hpp"

namespace idiophone::report {
namespace {

/// The integral of a squared sine, without its click: A^2 / 2 for each second.
TEST(Exposure, IsTheIntegralOfTheSquareWhereverTheSoundIs) {
  for (const double start : {0.0, 0.7}) {
    const Tone tone{.start = start, .frequency = 1000.0, .amplitude = 0.2, .decay_time = 1.0};
    std::vector<double> samples = blows({tone}, 2.0);
    double sum = 0.0;
    for (const double sample : samples) {
      sum += sample * sample / rate;
    }
    EXPECT_NEAR(exposure(samples, rate).level, 10 * std::log10(sum), 0.2);
  }
}

TEST(Exposure, ATrembleBelowHearingDoesNotHideTheTones) {
  std::vector<double> samples = blows({{.frequency = 6000.0, .decay_time = 0.5}}, 1.0);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    samples[n] += 100.0 * std::sin(2 * std::numbers::pi * 9.0 * static_cast<double>(n) / rate);
  }
  EXPECT_GT(exposure(samples, rate).highest, 6000.0);
  EXPECT_EQ(exposure(std::vector<double>(100, 0.0), rate).highest, rate / 2);
}

}  // namespace
}  // namespace idiophone::report
