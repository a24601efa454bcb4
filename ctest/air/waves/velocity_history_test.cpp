#include "idiophone/air/waves/velocity_history.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "ranks.hpp"

namespace idiophone::waves {
namespace {

constexpr int steps_per_sample = 4;

/// Largest error of the changes of sin(w t), w in radians per audio sample, over w/steps_per_sample.
double error(double w) {
  VelocityHistory history(1, steps_per_sample);
  double largest = 0.0;
  for (int newest = 0; newest < 100; ++newest) {
    const std::array value = {static_cast<float>(std::sin(w * newest))};
    history.push(value);
    for (int step = 0; step < steps_per_sample && newest > 40; ++step) {
      const double time = newest - VelocityHistory::latency() - 1 + static_cast<double>(step) / steps_per_sample;
      std::array<float, 1> change{};
      history.changes(step, change);
      const double exact =
          std::sin(w * (time + 0.5 / steps_per_sample)) - std::sin(w * (time - 0.5 / steps_per_sample));
      largest = std::max(largest, std::abs(change[0] - exact));
    }
  }
  return largest / (w / steps_per_sample);
}

ON_RANKS(1);

TEST(VelocityHistory, InterpolatesBetweenAudioSamples) {
  for (const double cycles : {0.001, 0.05, 0.2, 0.35}) {
    EXPECT_LT(error(2.0 * std::numbers::pi * cycles), 4e-3) << cycles << " of the rate";
  }
}

TEST(VelocityHistory, KnowsNoChangeOfWhatIsConstant) {
  VelocityHistory history(1, steps_per_sample);
  const std::array value = {3.0F};
  history.fill(value);
  std::array<float, 1> change{};
  for (int step = 0; step < steps_per_sample; ++step) {
    history.changes(step, change);
    EXPECT_NEAR(change[0], 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace idiophone::waves
