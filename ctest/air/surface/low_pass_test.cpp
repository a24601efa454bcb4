// The low-pass of pressures and positions, as it is heard behind a surface (paper, eqs. 6 to 8).

#include <gtest/gtest.h>

#include "driven.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

/// Eqs. 6-8 summed directly: the response of the normalised kernel with taps at every step.
double kernel_response(double frequency, double max_frequency, double step, int w) {
  double sum = 0.0, total = 0.0;
  for (int i = -w; i <= w; ++i) {
    const double t = i * step;
    const double sinc = i == 0 ? 2.0 * max_frequency : std::sin(2.0 * pi * max_frequency * t) / (pi * t);
    const double tap = sinc * (0.5 + 0.5 * std::cos(pi * i / w));
    sum += tap * std::cos(2.0 * pi * frequency * t);
    total += tap;
  }
  return sum / total;
}

ON_RANKS(1);

TEST(LowPass, IsMinusSixDecibelsAtTheCutoff) {
  EXPECT_NEAR(decibels(pressure_response(22050.0, paper)), -6.02, 0.03);
}

TEST(LowPass, IsMinusFortyFourDecibelsAt29kHz) {
  EXPECT_NEAR(decibels(pressure_response(29000.0, paper)), -44.0, 1.0);
}

TEST(LowPass, IsFlatBelowWithoutDelay) {
  for (const double frequency : {20.0, 1000.0, 5000.0, 10000.0, 13000.0}) {
    const auto response = pressure_response(frequency, paper);
    EXPECT_NEAR(decibels(response), 0.0, 0.02) << frequency;
    EXPECT_NEAR(std::arg(response), 0.0, 1e-4) << frequency;
  }
}

TEST(LowPass, IsThePapersKernelWhateverTheReads) {
  for (const int steps_per_read : {1, 2, 4}) {
    Sampling sampling = paper;
    sampling.steps_per_read = steps_per_read;
    const double step = 1.0 / (44100.0 * 24.0);
    EXPECT_EQ(sampling.half_width(), 144);
    for (const double frequency : {3000.0, 18000.0, 20000.0, 22050.0, 24000.0}) {
      EXPECT_NEAR(pressure_response(frequency, sampling).real(), kernel_response(frequency, 22050.0, step, 144), 1e-3)
          << frequency << " Hz, reads of " << steps_per_read << " steps";
    }
  }
}

TEST(LowPass, RestoresWhatTheMeanOverAReadLoses) {
  // By itself the mean over a sixth of an audio sample loses 0.08 dB of 20 kHz.
  const double lost = std::sin(pi * 20000.0 / (6 * 44100.0)) / (pi * 20000.0 / (6 * 44100.0));
  const double expected = kernel_response(20000.0, 22050.0, 1.0 / (44100.0 * 24.0), 144);
  EXPECT_NEAR(20.0 * std::log10(lost), -0.08, 0.01);
  EXPECT_NEAR(pressure_response(20000.0, paper).real() / expected, 1.0, 0.001);
}

TEST(LowPass, HandlesManyReadsAndUnevenSteps) {
  const Sampling sampling{.rate = 44100, .steps_per_sample = 37, .steps_per_read = 1};
  EXPECT_NEAR(pressure_response(18000.0, sampling).real(),
              kernel_response(18000.0, 22050.0, 1.0 / (44100.0 * 37.0), 222), 1e-3);
}

TEST(LowPass, HandlesALowerCutoff) {
  const Sampling sampling{
      .rate = 48000, .steps_per_sample = 20, .steps_per_read = 4, .max_frequency = 7000.0, .kernel_wavelengths = 4.5};
  EXPECT_EQ(sampling.latency(), 31);
  EXPECT_NEAR(decibels(pressure_response(7000.0, sampling)), -6.02, 0.05);
  EXPECT_NEAR(decibels(pressure_response(3000.0, sampling)), 0.0, 0.02);
}

TEST(LowPass, FiltersPositionsLikePressuresAtTheSampleItself) {
  for (const double frequency : {100.0, 10000.0, 22050.0, 29000.0}) {
    const double amplitude = 1e-4;
    Driven driven(
        [&](const Vector3&, double t) -> Vector3 {
          return {0, amplitude * std::cos(2 * pi * frequency * t), 0};
        },
        paper);
    driven.advance(900);
    const auto response =
        fit([&](int i) { return (driven.at(i).centre[1][0] - 0.01 / 3.0) / amplitude; }, frequency, 44100, 400, 480);
    EXPECT_NEAR(response.real(), kernel_response(frequency, 22050.0, 1.0 / (44100.0 * 24.0), 144), 1e-3) << frequency;
    EXPECT_NEAR(response.imag(), 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace idiophone::surface
