#include "idiophone/study/partials/free_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace idiophone::partials {
namespace {

constexpr double sample_rate = 44100.0;

/// Noise, hum of 50 Hz and a tone of 1 kHz that is struck at times (s) and decays by 60 dB in 0.8 s.
std::vector<double> recording(const std::vector<double>& blows, double duration) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 1e-3);
  std::vector<double> samples(static_cast<std::size_t>(duration * sample_rate));
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double time = static_cast<double>(n) / sample_rate;
    samples[n] = normal(generator) + 0.3 * std::sin(2 * std::numbers::pi * 50 * time);
    for (const double blow : blows) {
      const double since = time - blow;
      samples[n] += since < 0 ? 0.0 : std::exp(-since * std::log(1000.0) / 0.8) * std::sin(6283.2 * since);
    }
  }
  return samples;
}

TEST(FreeParts, BeginAfterTheBlowAndEndBeforeTheNextClick) {
  std::vector<double> samples = recording({1.0}, 3.0);
  samples[static_cast<std::size_t>(1.7 * sample_rate)] += 2.0;
  const FreePart part = free_parts(samples, sample_rate).front();
  EXPECT_NEAR(part.start, 1.02, 0.008);
  EXPECT_NEAR(part.start + part.duration, 1.7, 0.003);
}

TEST(FreeParts, AClickBeforeTheBlowIsNoBlow) {
  std::vector<double> samples = recording({1.0}, 3.0);
  samples[static_cast<std::size_t>(0.3 * sample_rate)] += 10.0;
  const FreePart part = free_parts(samples, sample_rate).front();
  EXPECT_NEAR(part.start, 1.02, 0.008);
  EXPECT_NEAR(part.start + part.duration, 3.0, 1e-3);
}

TEST(FreeParts, AreAllThatThereAreBetweenBlows) {
  const std::vector<FreePart> parts = free_parts(recording({0.5, 1.5, 2.0}, 3.5), sample_rate);
  ASSERT_EQ(parts.size(), 4U) << "and the one before the first blow";
  EXPECT_NEAR(parts.front().start, 2.02, 0.008) << "the longest";
}

TEST(FreeParts, ASoundThatBeginsWithItsBlow) {
  std::vector<double> samples = recording({-0.001}, 1.0);
  const FreePart part = free_parts(samples, sample_rate).front();
  EXPECT_LT(part.start, 0.05);
  EXPECT_NEAR(part.start + part.duration, 1.0, 1e-3);
}

// Half of each beat rises.
TEST(FreeParts, BeatsAreNoBlows) {
  std::vector<double> samples(static_cast<std::size_t>(2 * sample_rate));
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double time = static_cast<double>(n) / sample_rate;
    samples[n] = std::sin(6283.2 * time) + std::sin((6283.2 + 30) * time);
  }
  EXPECT_EQ(free_parts(samples, sample_rate).size(), 1U);
}

}  // namespace
}  // namespace idiophone::partials
