#include "idiophone/foundation/spectra/spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "sounds.hpp"

namespace idiophone::spectra {
namespace {

using partials::Planted;
using partials::rate;

constexpr double for_ever = 1e12;

TEST(Spectrum, AUnitSineReadsItsAmplitude) {
  const auto samples = partials::sound(std::vector<Planted>{{.frequency = 1000.0, .decay_time = for_ever}}, 1.0);
  const Spectrum result = spectrum(samples, rate);
  EXPECT_DOUBLE_EQ(result.frequency_step, 1.0);
  ASSERT_EQ(result.level.size(), 22051);
  EXPECT_NEAR(result.level[1000], 0.0, 1e-9);
  EXPECT_NEAR(result.level[1001], -6.0206, 1e-3);  // the Hann window's next bin
  EXPECT_LT(result.level[1010], -120.0);
}

TEST(Spectrum, BetweenTwoBinsItReadsAtMost142HundredthsOfADecibelLess) {
  const auto samples = partials::sound(std::vector<Planted>{{.frequency = 1000.5, .decay_time = for_ever}}, 1.0);
  EXPECT_NEAR(spectrum(samples, rate).level[1000], -1.4236, 1e-3);
}

TEST(Spectrum, TheOffsetReadsItself) {
  const std::vector<double> samples(1000, 0.1);
  EXPECT_NEAR(spectrum(samples, rate).level[0], -20.0, 1e-9);
}

TEST(Spectrum, AtHalfTheRateToo) {
  std::vector<double> samples(1000);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    samples[n] = n % 2 == 0 ? 0.1 : -0.1;
  }
  EXPECT_NEAR(spectrum(samples, rate).level[500], -20.0, 1e-9);
}

TEST(Spectrum, SilenceHasALevel) {
  const std::vector<double> samples(100);
  for (const double level : spectrum(samples, rate).level) {
    EXPECT_EQ(level, silence);
  }
}

TEST(Spectrum, WrongInputIsRefused) {
  EXPECT_THROW((void)spectrum(std::vector<double>{1.0}, rate), std::invalid_argument);
  EXPECT_THROW((void)spectrum(std::vector<double>(10), -1.0), std::invalid_argument);
  EXPECT_THROW((void)spectrum(std::vector<double>(10, std::numeric_limits<double>::infinity()), rate),
               std::invalid_argument);
}

TEST(Spectrogram, ADecayFallsAsFastAsItShould) {
  // 16 periods in a block; 60 dB in half a second.
  const double frequency = 16.0 * rate / 2048.0;
  const auto samples = partials::sound(std::vector<Planted>{{.frequency = frequency, .decay_time = 0.5}}, 0.5);
  const Spectrogram result = spectrogram(samples, rate);
  ASSERT_EQ(result.bins, 1025);
  ASSERT_EQ(result.blocks, (22050 - 2048) / 512 + 1);
  ASSERT_EQ(result.level.size(), result.bins * result.blocks);
  EXPECT_DOUBLE_EQ(result.first_time, 1024.0 / rate);
  for (std::size_t b = 0; b < result.blocks; ++b) {
    const double time = result.first_time + static_cast<double>(b) * result.time_step;
    EXPECT_NEAR(result.level[b * result.bins + 16], -120.0 * time, 0.4) << b;
  }
}

TEST(Spectrogram, EachBlockIsASpectrum) {
  const auto samples = partials::sound(std::vector<Planted>{{.frequency = 700.0}}, 0.1);
  const Spectrogram all = spectrogram(samples, rate, {.block = 1000, .hop = 300});
  const Spectrum third = spectrum(std::span(samples).subspan(600, 1000), rate);
  EXPECT_DOUBLE_EQ(all.frequency_step, third.frequency_step);
  for (std::size_t k = 0; k < all.bins; ++k) {
    EXPECT_DOUBLE_EQ(all.level[2 * all.bins + k], third.level[k]);
  }
}

TEST(Spectrogram, WrongInputIsRefused) {
  const std::vector<double> samples(100);
  EXPECT_THROW((void)spectrogram(samples, rate), std::invalid_argument);
  EXPECT_THROW((void)spectrogram(samples, rate, {.block = 1, .hop = 1}), std::invalid_argument);
  EXPECT_THROW((void)spectrogram(samples, rate, {.block = 10, .hop = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::spectra
