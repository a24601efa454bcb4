#include "up_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace idiophone::proxies {
namespace {

TEST(UpSampling, HermiteCurveFollowsEquation51) {
  const std::array<double, 4> samples = {1.0, 3.0, -2.0, 5.0};
  EXPECT_EQ(hermite(samples, 0.0), 3.0);
  EXPECT_EQ(hermite(samples, 1.0), -2.0);
  EXPECT_DOUBLE_EQ(hermite(samples, 0.5), 0.5 * 3.0 + 0.125 * 2.0 - 0.5 * 2.0 - 0.125 * 7.0);
  constexpr double step = 1e-6;
  EXPECT_NEAR((hermite(samples, step) - 3.0) / step, 2.0, 1e-4);         // from the first to the second
  EXPECT_NEAR((-2.0 - hermite(samples, 1.0 - step)) / step, 7.0, 1e-4);  // from the third to the fourth
}

TEST(UpSampling, AllDivisorsHaveTheSameDelay) {
  constexpr int largest = 8;
  UpSampler up(largest);
  for (const int divisor : {1, 2, 4, 8}) {
    up.restart(divisor);
    for (int sample = 0; sample < 200; ++sample) {
      if (sample % divisor == 0) {
        up.add(0.25 * sample);  // a straight line is exact
      }
      const double value = up.take(sample % divisor);
      if (sample > 60) {
        EXPECT_NEAR(value, 0.25 * (sample - static_cast<int>(UpSampler::delay(largest))), 1e-9) << divisor;
      }
    }
  }
}

TEST(UpSampling, FullRateIsNotDelayed) {
  UpSampler up(1);
  up.add(2.5);
  EXPECT_EQ(up.take(0), 2.5);
}

}  // namespace
}  // namespace idiophone::proxies
