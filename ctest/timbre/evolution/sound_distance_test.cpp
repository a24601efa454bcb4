// The distance of two sounds, where it is known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/timbre/evolution/evolution.hpp"
#include "ranks.hpp"
#include "sounding.hpp"
#include "temporary_sound.hpp"

namespace idiophone::timbre {

namespace {

std::vector<double> scaled(std::vector<double> sound, double factor) {
  for (double& sample : sound) {
    sample *= factor;
  }
  return sound;
}

}  // namespace

ON_RANKS(1);

TEST(SoundDistances, OfAnOverallGainAreThreeTimesItsDecibels) {  // two spectra and the envelope; noise has no floor
  const auto noise = sound_of("white", 16384);
  const SoundDistance distance({.samples = noise});
  for (const double factor : {0.5, 2.0, 4.0}) {
    EXPECT_NEAR(distance(scaled(noise, factor)), 3.0 * std::abs(20.0 * std::log10(factor)), 0.01) << factor;
  }
}

TEST(SoundDistances, DoNotHearWhatIsMoreThan60DecibelsBelowTheTarget) {
  const auto noise = sound_of("white", 16384), other = sound_of("(white 2)", 16384);
  auto disturbed = noise;  // two sounds in turn, of which the second is below the floor
  auto target = noise;
  for (std::size_t i = 8192; i < noise.size(); ++i) {
    target[i] = 0.0;
    disturbed[i] = 1e-4 * other[i];
  }
  EXPECT_LT(SoundDistance({.samples = target})(disturbed), 1e-2);  // of the blocks that have both
  for (std::size_t i = 8192; i < noise.size(); ++i) {
    disturbed[i] = 0.1 * other[i];
  }
  EXPECT_GT(SoundDistance({.samples = target})(disturbed), 10.0);
}

TEST(SoundDistances, OfSilenceAreTheLevelsAboveTheFloor) {
  const auto noise = sound_of("white", 16384);
  const double distance = SoundDistance({.samples = noise})(std::vector<double>(16384));
  EXPECT_GT(distance, 130.0);  // less than three times 60 dB: noise is below its loudest bin
  EXPECT_LT(distance, 180.0);
}

TEST(SoundDistances, GrowWithTheDistanceOfTwoPitches) {
  const SoundDistance distance({.samples = sound_of("(sine 1000)", 16384)});
  double last = 0.0;
  for (const char* tree : {"(sine 1005)", "(sine 1020)", "(sine 1060)"}) {
    const double next = distance(sound_of(tree, 16384));
    EXPECT_GT(next, last) << tree;
    last = next;
  }
}

TEST(SoundDistances, AreAudibleForAThirdOfASemitoneAndForLongerDecays) {
  const auto difference = [](const char* first, const char* second) {
    return SoundDistance({.samples = sound_of(first, 44100)})(sound_of(second, 44100));
  };
  EXPECT_LT(difference("(sine 1000)", "(sine 1010)"), audible_distance);
  EXPECT_GT(difference("(sine 1000)", "(sine 1025)"), audible_distance);
  EXPECT_LT(difference("(* (damp 1000 0.002) (sine 1000))", "(* (damp 1000 0.0021) (sine 1000))"), audible_distance);
  EXPECT_GT(difference("(* (damp 1000 0.002) (sine 1000))", "(* (damp 1000 0.0024) (sine 1000))"), audible_distance);
}

TEST(SoundDistances, DoNotHearThePhaseOfASteadySound) {
  const SoundDistance distance({.samples = sound_of("(sine 1000)", 16384)});
  EXPECT_LT(distance(sound_of("(sine 1000 0.3)", 16384)), 0.2 * distance(sound_of("(sine 1060)", 16384)));
}

TEST(SoundDistances, NeedTwoBlocksOfATarget) {
  const support::TemporarySound enough(44100, {std::vector<double>(4096, 0.5)});
  EXPECT_EQ(read_target(enough.path(), 44100).samples.size(), 4096U);
  const support::TemporarySound brief(44100, {std::vector<double>(4095, 0.5)});
  EXPECT_THROW(static_cast<void>(read_target(brief.path(), 44100)), std::runtime_error);
}

}  // namespace idiophone::timbre
