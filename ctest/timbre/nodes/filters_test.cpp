// Filters, by their exact frequency responses.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "measured.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Filters, HaveTheirGainsAtTheirFrequencies) {
  const auto gain = [](const std::string& filter, int cycles) {
    const auto sound =
        sound_of("(define x (sine (/ (* rate " + std::to_string(cycles) + ") 8192)))" + filter, std::size_t{4} * 8192);
    return std::abs(line(std::vector(sound.end() - 8192, sound.end()), cycles / 8192.0));
  };
  EXPECT_NEAR(gain("(lowpass x (/ (* rate 100) 8192))", 100), std::sqrt(0.5), 0.03);
  EXPECT_NEAR(gain("(highpass x 2000)", 1), 0.0, 0.01);
  EXPECT_NEAR(gain("(bandpass x (/ (* rate 500) 8192) 10)", 500), 1.0, 1e-6);
  EXPECT_NEAR(gain("(bandpass x (/ (* rate 500) 8192) 10)", 525), 1.0 / std::sqrt(1.0 + 0.95 * 0.95), 0.03);
  EXPECT_NEAR(gain("(fir x (vector 0.5 0 0.5))", 2048), 0.0, 1e-9);
  EXPECT_NEAR(gain("(biquad x 1 0 0 -0.5 0)", 0), 0.0, 1e-9);
}

TEST(Filters, HavePossibleFrequencies) {
  EXPECT_EQ(mistakes_of("(lowpass white -1)"),
            "t.tt:1:1: the frequency of a filter is between 0 and half the rate, not -1");
  EXPECT_NE(mistakes_of("(highpass white rate)"), "");
  EXPECT_NE(mistakes_of("(combine (bandpass white (vector 100 30000) 5))"), "");
  EXPECT_EQ(mistakes_of("(bandpass white 100 0)"), "t.tt:1:1: the quality of a filter is above 0, not 0");
  EXPECT_THROW(static_cast<void>(sound_of("(lowpass white (- time))", 10)), std::runtime_error);
}

TEST(Filters, WorkOnEachComponent) {
  EXPECT_EQ(sound_of("(combine (fir (vector 1 2) (vector 1 10)) (vector 1 100))", 2), (std::vector{201.0, 2211.0}));
}

TEST(Filters, ComeToRestWithoutDenormals) {
  const auto sound = sound_of(
      "(+ (lowpass (timer 0 0.001 1) 200) (bandpass (timer 0 0.001 1) 900 1)"
      "   (damp 5000 0.1) (reverberate (timer 0 0.001 1) 0.01))",
      88200);
  for (const double sample : sound) {
    EXPECT_NE(std::fpclassify(sample), FP_SUBNORMAL);
  }
  EXPECT_EQ(sound.back(), 0.0);
}

TEST(Filters, OfOnePoleHaveTheirExactResponses) {
  const double pole = std::exp(-2.0 * std::numbers::pi * 1000.0 / 44100.0);
  const auto low = sound_of(fmt::format("(lowpass {} 1000)", impulse), 2000);
  const auto high = sound_of(fmt::format("(highpass {} 1000)", impulse), 2000);
  for (const double frequency : {0.0, 0.001, 0.02, 0.3, 0.5}) {
    const std::complex<double> expected =
        (1.0 - pole) / (1.0 - pole * std::polar(1.0, -2.0 * std::numbers::pi * frequency));
    EXPECT_LT(std::abs(response(low, frequency) - expected), 1e-12) << frequency;
    EXPECT_LT(std::abs(response(high, frequency) - (1.0 - expected)), 1e-12) << frequency;
  }
}

TEST(Filters, OfOnePoleAreExactForAStepWhileTheirFrequencyChanges) {  // y' = 2 pi f(t) (1 - y)
  const auto sound = sound_of("(lowpass (+ 1 (* 0 time)) (+ 100 (* 3000 time)))", 3000);
  double turns = 0.0;  // integral of f
  for (std::size_t i = 0; i < sound.size(); ++i) {
    turns += (100.0 + 3000.0 * static_cast<double>(i) / 44100.0) / 44100.0;
    ASSERT_NEAR(sound[i], -std::expm1(-2.0 * std::numbers::pi * turns), 1e-12) << i;
  }
}

TEST(Filters, OfABandHaveTheExactResponseOfAResonance) {
  // s/Q / (s^2 + s/Q + 1) with s = i tan(pi f) / tan(pi f0), which is what the trapezoidal rule makes of it.
  constexpr double centre = 900.0 / 44100.0;
  for (const double quality : {0.5, 4.0}) {
    const auto sound = sound_of(fmt::format("(bandpass {} 900 {})", impulse, quality), 20000);
    for (const double frequency : {0.001, 0.9 * centre, centre, 1.2 * centre, 0.2, 0.4}) {
      const std::complex<double> s(0.0, std::tan(std::numbers::pi * frequency) / std::tan(std::numbers::pi * centre));
      const std::complex<double> expected = s / quality / (s * s + s / quality + 1.0);
      EXPECT_LT(std::abs(response(sound, frequency) - expected), 1e-11) << quality << " " << frequency;
    }
  }
}

TEST(Filters, OfABandLoseEnergyWhileTheirFrequencyJumps) {  // free of input, from 200 Hz to 4200 Hz and back
  const auto sound = sound_of(fmt::format("(bandpass {} (+ 2200 (* 2000 (square 900))) 300)", impulse), 88200);
  const auto largest = [&](std::size_t begin) {
    double most = 0.0;
    for (std::size_t i = begin; i < begin + 8820; ++i) {
      most = std::max(most, std::abs(sound[i]));
    }
    return most;
  };
  EXPECT_GT(largest(0), 0.0);
  EXPECT_LT(largest(79380), 0.5 * largest(0));
}

TEST(Filters, OfSecondOrderHaveTheResponseOfTheirCoefficients) {
  const auto sound = sound_of(fmt::format("(biquad {} 0.5 -0.3 0.2 -1.2 0.81)", impulse), 1000);
  for (const double frequency : {0.0, 0.05, 0.1342, 0.25, 0.5}) {
    const std::complex<double> delay = std::polar(1.0, -2.0 * std::numbers::pi * frequency);
    const std::complex<double> expected =
        (0.5 - 0.3 * delay + 0.2 * delay * delay) / (1.0 - 1.2 * delay + 0.81 * delay * delay);
    EXPECT_LT(std::abs(response(sound, frequency) - expected), 1e-12) << frequency;
  }
}

TEST(Filters, OfALimpWallFollowTheMassLaw) {
  for (const double density : {0.5, 10.0}) {
    const auto behind = sound_of(fmt::format("(transmit {} {})", impulse, density), 60000);
    for (const double frequency : {50.0, 500.0, 4000.0, 16000.0, 22050.0}) {
      const std::complex<double> t = response(behind, frequency / 44100.0);
      const std::complex<double> ratio(0.0, std::numbers::pi * frequency * density / 415.0);
      const double tolerance = frequency > 10000.0 && frequency < 20000.0 ? 1.0 : 0.1;  // dB
      EXPECT_NEAR(20.0 * std::log10(std::abs(t * (1.0 + ratio))), 0.0, tolerance) << density << " " << frequency;
      if (frequency < 5000.0) {  // what is reflected
        EXPECT_NEAR(20.0 * std::log10(std::abs((1.0 - t) * (1.0 + ratio) / ratio)), 0.0, 0.15)
            << density << " " << frequency;
      }
    }
  }
  EXPECT_EQ(sound_of("(transmit (+ 1 time) 0)", 3), sound_of("(+ 1 time)", 3));
  EXPECT_NE(mistakes_of("(transmit white -1)"), "");
}

TEST(Filters, OfALimpWallGoOnFromBlockToBlock) {
  const std::string text = "(transmit (sine 300) (+ 3 time))";
  const std::vector<double> all = sound_of(text, 1000);
  std::vector<double> parts(1000);
  Graph pieces(parse_tree(text, "t.tt"), {}, {});
  for (std::size_t first = 0, length = 1; first < parts.size(); first += length, ++length) {
    length = std::min(length, parts.size() - first);
    pieces.render(std::span(parts).subspan(first, length));
  }
  EXPECT_EQ(all, parts);
}

TEST(Filters, OfTapsRespondWithTheirTaps) {
  EXPECT_EQ(sound_of(fmt::format("(fir {} (vector 3 -1 0.5))", impulse), 5), (std::vector{3.0, -1.0, 0.5, 0.0, 0.0}));
}

}  // namespace idiophone::timbre
