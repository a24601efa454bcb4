#include "idiophone/instruments/resonators/resonator_bank.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "rate.hpp"

namespace idiophone::resonators {

namespace {

using std::numbers::pi;

/// Modes with phi = 1 and one output that is the modal velocity.
class VelocityBank {
 public:
  explicit VelocityBank(const std::vector<Resonator>& resonators)
      : bank(of(resonators, &Resonator::turn)),
        gains(in_groups(of(resonators, &Resonator::velocity))),
        by_mean(in_groups(of(resonators, &Resonator::by_mean))),
        by_slope(in_groups(of(resonators, &Resonator::by_slope))) {}

  /// In blocks of so many samples; the force acts from the first one on.
  std::vector<double> play(const std::vector<ForcePiece>& force, std::size_t samples, std::size_t block) {
    std::vector<double> sound(samples);
    for (std::size_t first = 0; first < samples;) {
      const std::size_t limit = first < force.size() ? force.size() : samples;
      const std::size_t count = std::min({block, limit - first, ResonatorBank::most_samples});
      const bool acts = first < force.size();
      const Drive drive{.force = acts ? std::span(force).subspan(first, count) : std::span<const ForcePiece>(),
                        .by_mean = by_mean,
                        .by_slope = by_slope};
      bank.advance({&drive, acts ? 1UL : 0UL}, gains, 1, std::span(sound).subspan(first, count));
      first += count;
    }
    return sound;
  }

  static std::vector<Complex> of(const std::vector<Resonator>& resonators, Complex Resonator::*member) {
    std::vector<Complex> values(resonators.size());
    std::ranges::transform(resonators, values.begin(), member);
    return values;
  }

  ResonatorBank bank;
  std::vector<ModeGroup> gains, by_mean, by_slope;
};

/// q' of q'' + 2 d q' + w^2 q = t/T from rest: the exact solution, of a force that rises linearly to 1 at time T.
double velocity_of_ramp(double w, double d, double T, double t) {
  const double damped = std::sqrt(w * w - d * d);
  return (1.0 - std::exp(-d * t) * (std::cos(damped * t) + d / damped * std::sin(damped * t))) / (w * w * T);
}

std::vector<Resonator> some(std::size_t count) {
  std::vector<Resonator> resonators;
  for (std::size_t i = 0; i < count; ++i) {
    const double frequency = 50.0 * std::pow(400.0, static_cast<double>(i) / static_cast<double>(count));
    resonators.emplace_back(DampedOscillator(frequency, 3.0 + static_cast<double>(i)), rate);
  }
  return resonators;
}

}  // namespace

TEST(ResonatorBank, IsExactForForcesThatAreLinearInEachSample) {
  for (const double frequency : {0.5, 20.0, 440.0, 5000.0, 23000.0}) {
    for (const double decay : {0.0, 1.0, 300.0}) {
      const double w = 2.0 * pi * frequency;
      if (decay >= w) {
        continue;
      }
      VelocityBank body({Resonator({frequency, decay}, rate)});
      std::vector<ForcePiece> ramp(100);
      for (std::size_t n = 0; n < ramp.size(); ++n) {
        ramp[n] = {.mean = (static_cast<double>(n) + 0.5) / 100.0, .slope = 0.5 / 100.0};
      }
      const std::vector<double> found = body.play(ramp, 100, 64);
      const double scale = std::abs(velocity_of_ramp(w, decay, 100.0 / rate, 99.0 / rate)) + 1e-3 / w;
      for (std::size_t n = 0; n < 100; ++n) {
        EXPECT_NEAR(found[n], velocity_of_ramp(w, decay, 100.0 / rate, static_cast<double>(n) / rate), 1e-9 * scale)
            << frequency << " Hz, sample " << n;
      }
    }
  }
}

TEST(ResonatorBank, RingsWithItsFrequencyAndDecay) {
  const double frequency = 1234.5, decay = 7.0;
  const double damped = std::sqrt(std::pow(2.0 * pi * frequency, 2) - decay * decay);
  VelocityBank body({Resonator({frequency, decay}, rate)});
  body.play({{.mean = 1.0}}, 1, 1);
  const Complex begin = body.bank.state(0);
  body.play({}, rate, 64);
  const Complex expected = begin * std::exp(Complex(-decay, damped));
  EXPECT_NEAR(std::abs(body.bank.state(0) / expected - 1.0), 0.0, 1e-10);
}

TEST(ResonatorBank, GivesTheSameBitsInBlocksOfAnySize) {
  const std::vector<ForcePiece> force(37, {.mean = 0.7, .slope = -0.2});
  const std::vector<double> expected = VelocityBank(some(77)).play(force, 1000, 64);
  EXPECT_GT(std::abs(expected[500]), 0.0);
  for (const std::size_t block : {1U, 7U, 63U}) {
    EXPECT_EQ(VelocityBank(some(77)).play(force, 1000, block), expected) << block;
  }
}

TEST(ResonatorBank, RingsWithNoiseBelow120Decibels) {
  const std::size_t samples = 6000, second_blow = 3001;
  std::vector<ForcePiece> force(samples);  // zeros, too, are computed in double precision
  force[0].mean = force[second_blow].mean = 1.0;
  const std::vector<double> exact = VelocityBank(some(500)).play(force, samples, 64);
  VelocityBank ringing(some(500));
  std::vector<double> rung = ringing.play({force[0]}, second_blow, 64);
  std::ranges::copy(ringing.play({force[0]}, samples - second_blow, 64), std::back_inserter(rung));
  double power = 0.0, noise = 0.0;
  for (std::size_t i = 0; i < samples; ++i) {
    power += exact[i] * exact[i];
    noise += std::pow(rung[i] - exact[i], 2);
  }
  EXPECT_GT(power, 0.0);
  EXPECT_LT(noise, 1e-12 * power);
}

TEST(ResonatorBank, GivesEachOutputItsGains) {
  const std::size_t block = 64;
  std::vector<ForcePiece> tap(block);
  tap[0].mean = 1.0;
  const std::vector<double> expected = VelocityBank(some(40)).play(tap, 2 * block, block);
  VelocityBank four(some(40));
  std::vector<ModeGroup> gains;
  for (const double factor : {1.0, 0.0, -2.0, 0.5}) {
    for (ModeGroup group : four.gains) {
      for (std::size_t p = 0; p < packs_in_group; ++p) {
        group.real[p] *= factor;
        group.imaginary[p] *= factor;
      }
      gains.push_back(group);
    }
  }
  std::vector<double> sound(2 * 4 * block);
  const Drive drive{.force = tap, .by_mean = four.by_mean, .by_slope = four.by_slope};
  four.bank.advance({&drive, 1}, gains, 4, std::span(sound).first(4 * block));
  four.bank.advance({}, gains, 4, std::span(sound).last(4 * block));
  for (std::size_t i = 0; i < 2 * block; ++i) {
    const double tolerance = i < block ? 1e-15 : 1e-9;  // single precision while nothing acts
    EXPECT_NEAR(sound[4 * i], expected[i], tolerance);
    EXPECT_EQ(sound[4 * i + 1], 0.0);
    EXPECT_NEAR(sound[4 * i + 2], -2.0 * expected[i], tolerance);
    EXPECT_NEAR(sound[4 * i + 3], 0.5 * expected[i], tolerance);
  }
}

TEST(ResonatorBank, KeepsItsStateWhenFrequenciesChange) {
  VelocityBank body({Resonator({440.0, 0.0}, rate)});
  body.play({{.mean = 1.0}}, 100, 64);
  const double before = std::abs(body.bank.state(0));
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Complex> turn = {Resonator({440.0 * std::pow(2.0, i / 500.0), 0.0}, rate).turn};
    body.bank.retune(in_groups(turn), 1.0);
    body.play({}, 64, 64);
  }
  EXPECT_NEAR(std::abs(body.bank.state(0)) / before, 1.0, 1e-10);
}

TEST(ResonatorBank, FallsSilentBeforeNumbersBecomeDenormal) {
  VelocityBank body({Resonator({1000.0, 500.0}, rate)});
  body.play({{.mean = 1.0}}, 64, 64);
  EXPECT_TRUE(body.bank.sounds());
  for (int i = 0; i < 3 * rate / 64; ++i) {  // exp(-1500): far below the smallest number
    body.play({}, 64, 64);
    body.bank.silence();
    EXPECT_TRUE(body.bank.state(0) == 0.0 || std::abs(body.bank.state(0)) > 1e-100);
  }
  EXPECT_FALSE(body.bank.sounds());
  EXPECT_EQ(body.bank.state(0), 0.0);
}

TEST(ResonatorBank, GroupsThatLeaveRingOnUnheard) {
  constexpr std::size_t fade = 128, count = 3 * modes_in_group;
  VelocityBank whole(some(count)), chosen(some(count)), two(some(count));
  for (VelocityBank* body : {&whole, &chosen, &two}) {
    body->play({{.mean = 1.0}}, 128, 64);
  }
  two.gains[0] = {};  // what is heard without the first group
  const auto play = [](VelocityBank& body) { return body.play({}, fade, 64); };
  chosen.bank.choose(std::vector<char>{0, 1, 1}, fade);
  const std::vector<double> all = play(whole), without = play(two), leaving = play(chosen);
  for (std::size_t i = 0; i < fade; ++i) {
    const double weight = 1.0 - static_cast<double>(i) / fade;
    EXPECT_NEAR(leaving[i], without[i] + weight * (all[i] - without[i]), 1e-9);
  }
  chosen.bank.choose(std::vector<char>{0, 1, 1}, fade);
  play(whole);
  const std::vector<double> expected = play(two), unheard = play(chosen);
  chosen.bank.choose(std::vector<char>{1, 1, 1}, fade);
  play(whole);
  play(chosen);
  const std::vector<double> before = play(whole), returned = play(chosen);
  for (std::size_t i = 0; i < fade; ++i) {
    EXPECT_NEAR(unheard[i], expected[i], 1e-9);
    EXPECT_NEAR(returned[i], before[i], 1e-9);
  }
}

TEST(ResonatorBank, ForceMakesAllGroupsHeardWithoutAStep) {
  constexpr std::size_t fade = 128;
  VelocityBank body(some(2 * modes_in_group));
  body.play({{.mean = 1.0}}, 128, 64);
  body.bank.choose(std::vector<char>{0, 1}, fade);
  body.play({}, fade / 2, 64);
  VelocityBank goes_on = body;
  const std::vector<double> expected = goes_on.play({}, 1, 1);
  const std::vector<double> driven = body.play({{.mean = 0.0}, {.mean = 1.0}}, 2, 2);
  EXPECT_NEAR(driven[0], expected[0], 1e-9);
  EXPECT_TRUE(body.bank.is_heard());
}

TEST(ResonatorBank, FallsSilentModeByMode) {
  VelocityBank body({Resonator({500.0, 0.0}, rate), Resonator({1000.0, 500.0}, rate)});
  body.play({{.mean = 1.0}}, 64, 64);
  for (int i = 0; i < rate / 64; ++i) {  // exp(-500)
    body.play({}, 64, 64);
    body.bank.silence();
  }
  EXPECT_GT(std::abs(body.bank.state(0)), 0.0);
  EXPECT_EQ(body.bank.state(1), 0.0);
}

}  // namespace idiophone::resonators
