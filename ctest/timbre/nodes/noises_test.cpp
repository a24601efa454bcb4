// Noises, by their distributions and spectra.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "measured.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Noises, HaveTheirMomentsAndSpectra) {
  const auto white = sound_of("(white)", 100000);
  EXPECT_NEAR(mean(white), 0.0, 0.01);
  EXPECT_NEAR(mean_square(white), 1.0 / 3.0, 0.01);
  const auto pink = sound_of("(pink)", 1 << 18);
  EXPECT_NEAR(mean_square(pink), 1.0, 0.3);
  const auto power_in_octave = [&](double lowest) {
    double power = 0.0;
    for (int i = 0; i < 300; ++i) {
      power += std::norm(line(pink, lowest * (1.0 + i / 300.0) / 44100.0));
    }
    return power / 300.0;
  };
  const double low = power_in_octave(60.0);
  for (const double factor : {2.0, 8.0, 32.0, 128.0}) {
    EXPECT_NEAR(10.0 * std::log10(power_in_octave(60.0 * factor) / low), -10.0 * std::log10(factor), 1.5) << factor;
  }
  EXPECT_NE(sound_of("(white 1)", 10), sound_of("(white 2)", 10));
  EXPECT_NE(sound_of("(white 1)", 10), sound_of("(white 1.5)", 10));
  EXPECT_NE(sound_of("(white 1e300)", 10), sound_of("(white -1e300)", 10));
  EXPECT_NE(sound_of("(white)", 10), sound_of("(white)", 10, {}, {.start_seed = 2}));
}

TEST(Noises, OfPerlinAreSmoothAndZeroAtTheLattice) {
  const auto perlin = sound_of("(perlin 100)", 44100);
  for (std::size_t i = 0; i < perlin.size(); i += 441) {
    EXPECT_NEAR(perlin[i], 0.0, 1e-6);
  }
  for (std::size_t i = 1; i < perlin.size(); ++i) {
    ASSERT_LE(std::abs(perlin[i]), 1.0);
    ASSERT_LT(std::abs(perlin[i] - perlin[i - 1]), 0.02);
  }
  EXPECT_GT(mean_square(perlin), 0.02);
}

TEST(Noises, OfMarkovHaveTheCorrelationOfADampedOscillator) {
  constexpr double damping = 0.2, frequency = 500.0;
  const auto markov = sound_of("(markov 500 0.2)", 400000);
  EXPECT_NEAR(mean_square(markov), 1.0, 0.05);
  const double omega = 2.0 * std::numbers::pi * frequency, decay = damping * omega,
               turn = omega * std::sqrt(1.0 - damping * damping);
  for (const std::size_t lag : {10U, 44U, 88U}) {
    double correlation = 0.0;
    for (std::size_t i = lag; i < markov.size(); ++i) {
      correlation += markov[i] * markov[i - lag];
    }
    correlation /= static_cast<double>(markov.size() - lag);
    const double time = static_cast<double>(lag) / 44100.0;
    EXPECT_NEAR(correlation, std::exp(-decay * time) * (std::cos(turn * time) + decay / turn * std::sin(turn * time)),
                0.05);
  }
  EXPECT_NE(mistakes_of("(markov 10 1)"), "");
}

TEST(Noises, OfEqualSeedsHaveTheSameBitsAndOfOtherSeedsOthers) {
  for (const char* kind : {"white", "pink", "perlin 900", "markov 900 0.5"}) {
    const auto noise = [&](const char* seed) { return sound_of(fmt::format("({} {})", kind, seed), 1000); };
    EXPECT_EQ(noise("7"), noise("7")) << kind;
    EXPECT_NE(noise("7"), noise("8")) << kind;
    EXPECT_NE(noise("7"), noise("-7")) << kind;
  }
}

TEST(Noises, OfOneSeedAndTwoKindsAreIndependent) {
  const auto white = sound_of("(white 7)", 100000);
  const auto driven = sound_of("(biquad (pink 7) 1 0 0 0 0)", 100000);
  double product = 0.0;
  for (std::size_t i = 0; i < white.size(); ++i) {
    product += white[i] * driven[i] / 100000.0;
  }
  EXPECT_NEAR(product, 0.0, 0.02);
}

TEST(Noises, OfWhiteAreEvenlyDistributedAndUncorrelated) {
  const auto white = sound_of("(white 3)", 100000);
  std::array<int, 20> counts{};
  for (const double sample : white) {
    ASSERT_GE(sample, -1.0);
    ASSERT_LT(sample, 1.0);
    ++counts.at(static_cast<std::size_t>(10.0 * (sample + 1.0)));
  }
  double square = 0.0;
  for (const int count : counts) {
    square += (count - 5000.0) * (count - 5000.0) / 5000.0;
  }
  EXPECT_LT(square, 45.3);  // chi squared of 19 degrees of freedom: above it once in 1500 seeds
  for (const std::size_t lag : {1U, 2U, 64U, 1000U}) {
    EXPECT_NEAR(correlation(white, lag), 0.0, 0.005) << lag;  // five standard deviations
  }
}

TEST(Noises, OfPinkHavePowerOneAtAnyRate) {
  for (const int rate : {8000, 44100, 96000}) {
    double power = 0.0;
    for (const char* seed : {"1", "2", "3", "4", "5", "6", "7", "8"}) {
      power += mean_square(sound_of(fmt::format("(pink {})", seed), 1 << 16, {}, {.rate = rate})) / 8.0;
    }
    EXPECT_NEAR(power, 1.0, 0.15) << rate;
  }
}

TEST(Noises, OfPerlinRunBackAtNegativeFrequencies) {
  const auto sound = sound_of("(perlin (keyframe hold 0 300 0.25 -300))", 22050);
  for (std::size_t i = 1; i < 11000; ++i) {
    ASSERT_NEAR(sound[11025 + i], sound[11025 - i], 1e-9) << i;
  }
  EXPECT_GT(mean_square(sound), 0.02);
}

TEST(Noises, OfPerlinDifferInEachComponentAndStayFinite) {
  EXPECT_NE(sound_of("(combine (perlin (vector 900 900)) (vector 1 0))", 100),
            sound_of("(combine (perlin (vector 900 900)) (vector 0 1))", 100));
  EXPECT_THROW(static_cast<void>(sound_of("(perlin (+ 1e18 (* 1e18 time)))", 10)), std::runtime_error);
}

TEST(Noises, OfMarkovBeginInTheirSteadyState) {  // over many starts, the first samples are as all others
  double square = 0.0, product = 0.0;
  constexpr int starts = 4000;
  for (std::uint64_t start = 0; start < starts; ++start) {
    const auto sound = sound_of("(markov 3000 0.2)", 4, {}, {.start_seed = start});
    square += sound[0] * sound[0] / starts;
    product += sound[0] * sound[3] / starts;
  }
  const double omega = 2.0 * std::numbers::pi * 3000.0, decay = 0.2 * omega, turn = omega * std::sqrt(0.96);
  constexpr double time = 3.0 / 44100.0;
  EXPECT_NEAR(square, 1.0, 0.1);
  EXPECT_NEAR(product, std::exp(-decay * time) * (std::cos(turn * time) + decay / turn * std::sin(turn * time)), 0.1);
}

TEST(Noises, OfMarkovHavePossibleNumbers) {
  const std::string message =
      "t.tt:1:1: markov needs a frequency between 0 and half the rate, and a damping between 0 and 1";
  for (const char* tree : {"(markov 0)", "(markov 22050)", "(markov 10 0)", "(markov 10 1)"}) {
    EXPECT_EQ(mistakes_of(tree), message) << tree;
  }
}

}  // namespace idiophone::timbre
