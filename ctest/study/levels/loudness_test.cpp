#include "idiophone/study/levels/loudness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace idiophone::levels {
namespace {

std::vector<double> sine(double level, double sampling, double duration) {
  std::vector<double> samples;
  for (double n = 0; n < duration * sampling; ++n) {
    samples.push_back(std::pow(10.0, level / 20.0) * std::sin(2.0 * std::numbers::pi * 1000.0 * n / sampling));
  }
  return samples;
}

/// EBU Tech 3341, case 1: a stereo sine of 1000 Hz whose peaks are at -23 dB re full scale.
TEST(Loudness, TheReferenceSineHasMinus23Lufs) {
  for (const double sampling : {44100.0, 48000.0}) {
    const std::vector<double> channel = sine(-23.0, sampling, 5.0);
    const Loudness loudness = loudness_of({channel, channel}, sampling, 1.0);
    EXPECT_NEAR(loudness.integrated.value_or(0.0), -23.0, 0.1);
    EXPECT_NEAR(loudness.true_peak.value_or(0.0), -23.0, 0.1);
    EXPECT_NEAR(loudness.range.value_or(9.0), 0.0, 0.1);
    EXPECT_NEAR(loudness_of({channel, channel}, sampling, 0.1).integrated.value_or(0.0), -3.0, 0.1);
  }
}

TEST(Loudness, ShortAndSilentSoundsHaveNone) {
  EXPECT_FALSE(loudness_of({sine(-23.0, 48000.0, 0.3)}, 48000.0, 1.0).integrated);
  const Loudness silent = loudness_of({std::vector<double>(48000, 0.0)}, 48000.0, 1.0);
  EXPECT_FALSE(silent.integrated);
  EXPECT_FALSE(silent.true_peak);
  EXPECT_FALSE(silent.range);
  EXPECT_FALSE(loudness_of(std::vector(65, sine(-23.0, 48000.0, 0.5)), 48000.0, 1.0).integrated);
  EXPECT_FALSE(loudness_of({sine(-23.0, 48000.0, 0.5)}, 8.0, 1.0).integrated);
}

}  // namespace
}  // namespace idiophone::levels
