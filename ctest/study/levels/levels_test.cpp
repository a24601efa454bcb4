#include "idiophone/study/levels/levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "idiophone/foundation/spectra/spectrum.hpp"
#include "idiophone/foundation/spectra/transform.hpp"

namespace idiophone::levels {
namespace {

constexpr double rate = 48000.0;
constexpr double reference = 20e-6;  // Pa

std::vector<double> tone(double frequency, double amplitude, double duration) {
  std::vector<double> samples;
  for (double n = 0; n < duration * rate; ++n) {
    samples.push_back(amplitude * std::sin(2.0 * std::numbers::pi * frequency * n / rate));
  }
  return samples;
}

double level_in(const Levels& levels, double nominal) {
  for (const ThirdOctave& band : levels.bands) {
    if (std::abs(band.nominal - nominal) < 1e-9 * nominal) {
      return band.level;
    }
  }
  ADD_FAILURE() << "there is no band of " << nominal << " Hz";
  return 0.0;
}

/// 1 Pa is 93.98 dB: the level of a calibrator.
TEST(Levels, ACalibratorHas94DecibelsWithAndWithoutWeighting) {
  const Levels levels = levels_of(tone(1000.0, std::numbers::sqrt2, 2.0), rate, reference);
  EXPECT_NEAR(levels.equivalent, 93.98, 0.01);
  EXPECT_NEAR(levels.weighted, 93.98, 0.02);
  EXPECT_NEAR(levels.exposure, 93.98 + 10.0 * std::log10(2.0), 0.02);
  EXPECT_NEAR(levels.peak, 96.99, 0.01);
  EXPECT_NEAR(level_in(levels, 1000), 93.98, 0.05);
  EXPECT_LT(level_in(levels, 800), 93.98 - 30.0);
  EXPECT_LT(level_in(levels, 1250), 93.98 - 30.0);
}

/// IEC 61672-1, table 3: the weighting A at nominal frequencies.
TEST(Levels, TheWeightingIsThatOfTheStandard) {
  for (const auto& [frequency, weight] :
       {std::pair{31.62, -39.4}, {63.10, -26.2}, {125.9, -16.1}, {501.2, -3.2}, {3981.0, 1.0}, {15849.0, -6.6}}) {
    const Levels levels = levels_of(tone(frequency, 1.0, 2.0), rate, 1.0);
    EXPECT_NEAR(levels.weighted - levels.equivalent, weight, 0.1) << frequency;
  }
}

TEST(Levels, APartOfASteadyToneHasItsLevelWhereverItIsCut) {
  const std::vector<double> whole = tone(39.81, 1.0, 2.0);
  const Levels levels = levels_of(std::span(whole).subspan(300, 40000), rate, 1.0, Beginning::inside);
  EXPECT_NEAR(levels.weighted - levels.equivalent, -34.6, 0.15);
  EXPECT_NEAR(level_in(levels, 40), -3.01, 0.3);
}

/// Pink noise has the same energy in each band: sines of amplitude f^(-1/2), at random phases.
TEST(Levels, PinkNoiseHasOneLevelInAllBands) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
  constexpr std::size_t size = 1 << 18;
  std::vector<std::complex<double>> spectrum(size / 2 + 1);
  for (std::size_t bin = 1; bin < size / 2; ++bin) {
    spectrum[bin] = std::polar(1.0 / std::sqrt(static_cast<double>(bin)), phase(random));
  }
  const Levels levels = levels_of(spectra::inverse_transform(spectrum, size), rate, 1.0);
  for (const ThirdOctave& band : levels.bands) {
    EXPECT_NEAR(band.level, level_in(levels, 1000), 0.4) << band.nominal;
  }
}

/// White noise: the energy in a band is its part of the spectrum. Together the bands have what lies between them.
TEST(Levels, BandsOfWhiteNoiseRiseByTenDecibelsADecade) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> samples(1 << 19);
  std::ranges::generate(samples, [&] { return normal(random); });
  const Levels levels = levels_of(samples, rate, 1.0);
  const double band_width = 1000.0 * (std::pow(10.0, 0.05) - std::pow(10.0, -0.05));
  EXPECT_NEAR(level_in(levels, 1000), 10.0 * std::log10(band_width / (0.5 * rate)), 0.2);
  EXPECT_NEAR(level_in(levels, 10000) - level_in(levels, 1000), 10.0, 0.2);
  EXPECT_NEAR(levels.equivalent, 0.0, 0.02);
  EXPECT_EQ(levels.bands.size(), 31U);
  EXPECT_EQ(levels.bands.front().nominal, 20.0);
  EXPECT_EQ(levels.bands[2].nominal, 31.5);
  EXPECT_EQ(levels.bands.back().nominal, 20000.0);
}

TEST(Levels, SilenceAndWrongInput) {
  EXPECT_EQ(levels_of(std::vector<double>(100, 0.0), rate, 1.0).weighted, spectra::silence);
  EXPECT_THROW(static_cast<void>(levels_of({}, rate, 1.0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(levels_of(std::vector<double>(9, NAN), rate, 1.0)), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::levels
