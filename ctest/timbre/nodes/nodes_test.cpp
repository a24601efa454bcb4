// The nodes of timbre trees, by what is known of their sounds.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "convolver.hpp"
#include "idiophone/timbre/nodes/random.hpp"
#include "sounding.hpp"
#include "temporary_sound.hpp"

namespace idiophone::timbre {

namespace {

using std::numbers::pi;
constexpr int rate = 44100;

/// Complex amplitude of the line at a frequency in cycles per sample.
std::complex<double> line(const std::vector<double>& sound, double frequency) {
  std::complex<double> sum;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    sum += sound[i] * std::polar(1.0, -2.0 * pi * frequency * static_cast<double>(i));
  }
  return 2.0 / static_cast<double>(sound.size()) * sum;
}

double mean(const std::vector<double>& sound) {
  return std::accumulate(sound.begin(), sound.end(), 0.0) / static_cast<double>(sound.size());
}

double mean_square(const std::vector<double>& sound) {
  return std::inner_product(sound.begin(), sound.end(), sound.begin(), 0.0) / static_cast<double>(sound.size());
}

/// The strongest alias below a quarter of the rate in a wave that has `cycles` (odd) cycles in 8192 samples, dB re its
/// fundamental.
double strongest_alias(const std::string& wave, int cycles) {
  constexpr int samples = 8192;
  const auto sound = sound_of("(" + wave + " (/ (* rate " + std::to_string(cycles) + ") 8192))", samples);
  double strongest = 0.0;
  for (int n = samples / (2 * cycles) + 1; n * cycles < 2 * samples; ++n) {
    const int folded = std::abs((n * cycles + samples / 2) % samples - samples / 2);
    if (4 * folded < samples) {
      strongest = std::max(strongest, std::abs(line(sound, folded / static_cast<double>(samples))));
    }
  }
  return 20.0 * std::log10(strongest / std::abs(line(sound, cycles / static_cast<double>(samples))));
}

}  // namespace

TEST(Oscillators, HaveTheSeriesOfFourier) {
  constexpr double frequency = 41.0 / 8192.0;
  const std::string argument = "(/ (* rate 41) 8192)";
  const auto sawtooth = sound_of("(sawtooth " + argument + ")", 8192);
  const auto square = sound_of("(square " + argument + ")", 8192);
  const auto triangle = sound_of("(triangle " + argument + ")", 8192);
  for (int n = 1; n < 50; ++n) {
    const double angle = pi * n * frequency;
    const double spline = std::pow(std::sin(angle) / angle, 4);  // transform of the cubic B-spline
    EXPECT_NEAR(std::abs(line(sawtooth, n * frequency)), spline * 2.0 / (pi * n), 1e-4);
    const double odd = n % 2 == 1 ? spline : 0.0;
    EXPECT_NEAR(std::abs(line(square, n * frequency)), odd * 4.0 / (pi * n), 1e-4);
    EXPECT_NEAR(std::abs(line(triangle, n * frequency)), odd * 8.0 / (pi * pi * n * n), 1e-4);
  }
}

TEST(Oscillators, HaveNoAudibleAliases) {
  for (const int cycles : {41, 185, 409}) {
    for (const char* wave : {"sawtooth", "square", "triangle"}) {
      EXPECT_LT(strongest_alias(wave, cycles), -60.0) << wave << " " << cycles;
    }
  }
  EXPECT_EQ(mean_square(sound_of("(+ (sine rate) (sawtooth (* 0.6 rate)))", 100)), 0.0);
}

TEST(Oscillators, TurnRoundAtNegativeFrequencies) {
  for (const char* wave : {"sine", "sawtooth"}) {
    EXPECT_LT(mean_square(sound_of(fmt::format("(+ ({0} 441) ({0} -441))", wave), 2000)), 1e-20) << wave;
  }
  EXPECT_LT(mean_square(sound_of("(- (triangle 441) (triangle -441))", 2000)), 1e-20);
}

TEST(Oscillators, HaveADutyFromZeroToOne) {
  EXPECT_EQ(mistakes_of("(square 100 1.5)"), "t.tt:1:1: a duty is a number from 0 to 1, not 1.5");
  EXPECT_THROW(static_cast<void>(sound_of("(square 100 (+ 1 time))", 10)), std::runtime_error);
  EXPECT_NEAR(mean(sound_of("(square 100 1)", 10)), 1.0, 1e-12);
}

TEST(Oscillators, SteadyAndVaryingSinesAgree) {
  const auto steady = sound_of("(sine 1234.5 0.1)", 100000);
  const auto varying = sound_of("(sine (+ 1234.5 (* 0 time)) 0.1)", 100000);
  for (std::size_t i = 0; i < steady.size(); i += 99) {
    ASSERT_NEAR(steady[i], std::sin(2.0 * pi * (1234.5 * static_cast<double>(i) / rate + 0.1)), 1e-8);
    ASSERT_NEAR(varying[i], steady[i], 1e-8);
  }
}

TEST(Noises, HaveTheirMomentsAndSpectra) {
  const auto white = sound_of("(white)", 100000);
  EXPECT_NEAR(mean(white), 0.0, 0.01);
  EXPECT_NEAR(mean_square(white), 1.0 / 3.0, 0.01);
  const auto pink = sound_of("(pink)", 1 << 18);
  EXPECT_NEAR(mean_square(pink), 1.0, 0.3);
  const auto power_in_octave = [&](double lowest) {
    double power = 0.0;
    for (int i = 0; i < 300; ++i) {
      power += std::norm(line(pink, lowest * (1.0 + i / 300.0) / rate));
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
  const double omega = 2.0 * pi * frequency, decay = damping * omega, turn = omega * std::sqrt(1.0 - damping * damping);
  for (const std::size_t lag : {10U, 44U, 88U}) {
    double correlation = 0.0;
    for (std::size_t i = lag; i < markov.size(); ++i) {
      correlation += markov[i] * markov[i - lag];
    }
    correlation /= static_cast<double>(markov.size() - lag);
    const double time = static_cast<double>(lag) / rate;
    EXPECT_NEAR(correlation, std::exp(-decay * time) * (std::cos(turn * time) + decay / turn * std::sin(turn * time)),
                0.05);
  }
  EXPECT_NE(mistakes_of("(markov 10 1)"), "");
}

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

TEST(Delays, KeepWavesBetweenSamples) {
  const auto sound = sound_of("(delay (sine 3000) 0.0123456)", 20000);
  for (std::size_t i = 2000; i < sound.size(); ++i) {
    ASSERT_NEAR(sound[i], std::sin(2.0 * pi * 3000.0 * (static_cast<double>(i) / rate - 0.0123456)), 1e-4);
  }
  EXPECT_EQ(sound_of("(delay (sine 3000) 0)", 99), sound_of("(sine 3000)", 99));
  EXPECT_NE(mistakes_of("(delay time 2)"), "");
  EXPECT_NE(mistakes_of("(delay time 2 1e9)"), "");
  EXPECT_THROW(static_cast<void>(sound_of("(delay time (- 0.001 time))", 100)), std::runtime_error);
}

TEST(Delays, ThatGrowLowerThePitch) {  // by Doppler's factor 1 - v/c
  const auto sound = sound_of("(delay (sine 1000) (+ 0.01 (* 0.1 time)) 2)", 44100);
  const std::vector<double> end(sound.end() - 22050, sound.end());
  EXPECT_NEAR(std::abs(line(end, 900.0 / rate)), 1.0, 1e-3);
}

TEST(Delays, ReverberationFallsBy60DecibelsInItsDecayTime) {
  const auto sound = sound_of("(reverberate (timer 0 0.00002 1) 0.8)", 44100);
  const auto energy_after = [&](double time) {
    return std::accumulate(sound.begin() + static_cast<std::ptrdiff_t>(time * rate), sound.end(), 0.0,
                           [](double sum, double sample) { return sum + sample * sample; });
  };
  const double slope = 10.0 * std::log10(energy_after(0.6) / energy_after(0.2)) / 0.4;  // Schroeder's integral, dB/s
  EXPECT_NEAR(-60.0 / slope, 0.8, 0.04);
}

TEST(Convolution, IsThatOfPlainSums) {
  const Random random(3);
  std::vector<double> taps(700), input(3000);
  for (std::size_t i = 0; i < input.size(); ++i) {
    input[i] = random.uniform(static_cast<std::int64_t>(i));
    taps[i % taps.size()] = random.uniform(-1 - static_cast<std::int64_t>(i % taps.size()));
  }
  Convolver convolver(taps);
  for (std::size_t i = 0; i < input.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k <= i && k < taps.size(); ++k) {
      sum += taps[k] * input[i - k];
    }
    ASSERT_NEAR(convolver.step(input[i]), sum, 1e-10);
  }
}

TEST(Samples, PlayAtOtherPitchesAndRates) {
  std::vector<double> recorded(22050);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    recorded[i] = std::sin(2.0 * pi * 500.0 * static_cast<double>(i) / rate);
  }
  const support::TemporarySound file(rate, {recorded});
  const std::string quoted = '"' + file.path().string() + '"';
  const auto plain = sound_of("(sample " + quoted + ")", 30000);
  EXPECT_NEAR(plain[1000], recorded[1000], 1e-6);
  EXPECT_EQ(plain.back(), 0.0);
  const auto octave = sound_of("(sample " + quoted + " 2)", 8820);
  EXPECT_NEAR(std::abs(line(octave, 1000.0 / rate)), 1.0, 0.01);
  const auto resampled = sound_of("(sample " + quoted + ")", 8000, {}, {.rate = 22050});
  EXPECT_NEAR(std::abs(line(resampled, 500.0 / 22050.0)), 1.0, 0.01);
  EXPECT_NE(mistakes_of("(sample \"nothing.wav\")"), "");
  EXPECT_EQ(mistakes_of("(sample " + quoted + " -1)"), "t.tt:1:1: the pitch of a sample is from 0 to 64, not -1");
}

TEST(Vectors, OfRandomNumbersBelongToTheBody) {
  const auto sum = [](std::uint64_t body, std::uint64_t start) {
    return sound_of("(combine (rvector 5 1 2))", 1, {}, {.body_seed = body, .start_seed = start}).front();
  };
  EXPECT_EQ(sum(1, 1), sum(1, 2));
  EXPECT_NE(sum(1, 1), sum(2, 1));
  EXPECT_NEAR(sum(1, 1), 7.5, 2.5);
  EXPECT_NE(mistakes_of("(combine (rvector 2.5 1 2))"), "");
}

TEST(Vectors, CombineAndDampModes) {
  EXPECT_EQ(sound_of("(combine (vector 1 2 3) (vector 1 10 100))", 1).front(), 321.0);
  const auto decay = sound_of("(damp 100 0.01)", 44101);
  EXPECT_NEAR(decay.back(), std::exp(-2.0 * pi), 1e-9);
}

TEST(Keyframes, InterpolateAndHold) {
  const auto at = [](const std::string& word, double time) {
    return sound_of("(keyframe " + word + " 0 0 1 2 2 4)", static_cast<std::size_t>(time * rate) + 1).back();
  };
  EXPECT_NEAR(at("linear", 0.5), 1.0, 1e-4);
  EXPECT_EQ(at("hold", 0.999), 0.0);
  EXPECT_NEAR(at("cubic", 1.0), 2.0, 1e-3);
  EXPECT_EQ(at("linear", 3.0), 4.0);
  EXPECT_NE(mistakes_of("(keyframe round 0 1)"), "");
  EXPECT_NE(mistakes_of("(keyframe linear 1 1 0 2)"), "");
}

}  // namespace idiophone::timbre
