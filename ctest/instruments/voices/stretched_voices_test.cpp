// Sound maps with large amplitudes, as a score plays them.

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "performance.hpp"
#include "sheet_map.hpp"
#include "sound_power.hpp"

namespace idiophone::voices {

namespace {

constexpr double lowest_tone = 200.0;  // Hz
constexpr double hardening = 1.5e6;    // H of one mode, J^1/2/(kg m2)

/// A sheet with the first modes of sheet_map.hpp, each of which stretches it by itself.
sound_maps::SoundMap stretched_sheet(std::size_t modes, double decay, const std::string& name = "sheet") {
  sound_maps::SoundMap map = sound_maps::sheet(name);
  map.frequency.resize(modes);
  map.material_decay.assign(modes, decay);
  map.radiation_decay.assign(modes, 0.0);
  map.shape.resize(modes * 3 * map.vertices.size());
  for (std::size_t mode = 0; mode < modes; ++mode) {
    map.frequency[mode] = lowest_tone * (1.0 + 0.83 * static_cast<double>(mode));
  }
  for (sound_maps::MapListener& listener : map.listeners) {
    listener.pressure.resize(modes);
  }
  map.sphere.pressure.resize(modes * map.sphere.direction.size());
  map.stretching.linear.assign(modes * modes, 0.0);
  map.stretching.quadratic.assign(modes * modes * modes, 0.0);
  map.stretching.rotation.assign(modes * modes, 0.0);
  for (std::size_t n = 0; n < modes; ++n) {
    for (std::size_t mode = 0; mode < modes; ++mode) {
      map.stretching.quadratic[(n * modes + mode) * modes + mode] = mode == n ? hardening : 0.3 * hardening;
    }
  }
  return map;
}

sound_maps::SoundMap without_stretching(sound_maps::SoundMap map) {
  map.stretching = {};
  return map;
}

score::Score one_blow(double speed) {
  score::Score score;
  score.duration = 1.0;
  score.events = {{.time = 0.0,
                   .body = 0,
                   .action = score::HammerBlow{.at = {0, 0, 0},
                                               .direction = -Vector3::UnitZ(),
                                               .hammer = {.mass = 0.01, .hardness = 1e10, .speed = speed}}}};
  return score;
}

std::vector<double> sound_of(const sound_maps::SoundMap& map, double speed, std::int64_t block = 512) {
  Performance performance({map}, one_blow(speed), rate);
  return rendered(performance, rate / 2, block);
}

/// Of the left channel after the blow, by its passages upwards through zero, Hz.
double pitch_of(const std::vector<double>& sound) {
  double first = 0.0, last = 0.0;
  int periods = -1;
  for (std::size_t i = 2000; i + 3 < sound.size(); i += 2) {
    if (sound[i] < 0.0 && sound[i + 2] >= 0.0) {
      last = static_cast<double>(i) / 2 + sound[i] / (sound[i] - sound[i + 2]);
      first = periods < 0 ? last : first;
      ++periods;
    }
  }
  return periods * rate / (last - first);
}

double level_of_difference(const std::vector<double>& one, const std::vector<double>& other) {
  std::vector<double> difference(one.size());
  std::ranges::transform(one, other, difference.begin(), std::minus());
  return 10.0 * std::log10(power(difference) / power(one));
}

/// Two sheets, of which a hard blow strikes those that are named, and which touch each other at a corner or do not.
std::vector<double> sound_of_two(const std::vector<sound_maps::SoundMap>& maps, const std::vector<std::size_t>& struck,
                                 const std::optional<std::array<std::size_t, 2>>& touching) {
  score::Score score = one_blow(10.0);
  const score::ScoreEvent blow = score.events.front();
  score.events.clear();
  for (const std::size_t body : struck) {
    score.events.push_back(blow);
    score.events.back().body = body;
  }
  if (touching) {
    score.contacts.push_back({.point = {.body = touching->front(), .at = {0.2, 0.2, 0.0}},
                              .direction = Vector3::UnitZ(),
                              .other = score::PointOfBody{.body = touching->back(), .at = {0.2, 0.2, 0.0}},
                              .mass = {},
                              .gap = {.points = {{.time = 0.0, .value = 1e-7}}},
                              .elasticity = {.hardness = 1e8, .loss = 0.2}});
  }
  Performance performance(maps, score, rate);
  return rendered(performance, 6000, 512);
}

}  // namespace

TEST(StretchedVoices, HaveThePitchOfDuffingsEquation) {
  const sound_maps::SoundMap map = stretched_sheet(1, 1e-3);
  const double w = 2.0 * std::numbers::pi * lowest_tone, participation = std::abs(map.shape[2]);
  for (const double speed : {0.01, 10.0, 30.0}) {
    const double energy = std::pow(participation * 2.0 * 0.01 * speed, 2) / 2.0;
    // w^2 q^2/2 + H^2 q^4/2 at the largest q. Nayfeh and Mook, Nonlinear Oscillations, 2.1: the period is
    // 4 K(k)/sqrt(w^2 + 2 H^2 q^2).
    const double cubic = 2.0 * hardening * hardening;
    const double square = (std::sqrt(w * w * w * w + 4.0 * cubic * energy) - w * w) / cubic;
    const double root = std::sqrt(w * w + cubic * square);
    const double pitch = root / (4.0 * std::comp_ellint_1(std::sqrt(cubic * square / 2.0) / root));
    EXPECT_NEAR(1200.0 * std::log2(pitch_of(sound_of(map, speed)) / pitch), 0.0, 1.0) << speed << ", " << pitch;
  }
}

TEST(StretchedVoices, SoundAsSmallVibrationsAfterWeakBlows) {
  const sound_maps::SoundMap map = stretched_sheet(20, 4.0);
  EXPECT_LT(level_of_difference(sound_of(map, 1e-4), sound_of(without_stretching(map), 1e-4)), -100.0);
  EXPECT_GT(level_of_difference(sound_of(map, 10.0), sound_of(without_stretching(map), 10.0)), -10.0);
}

TEST(StretchedVoices, DoNotDependOnBlocks) {
  const sound_maps::SoundMap map = stretched_sheet(20, 40.0);  // the stretching ends while it sounds
  EXPECT_EQ(sound_of(map, 3.0, 512), sound_of(map, 3.0, 77));
}

TEST(StretchedVoices, StayFiniteHoweverStrongTheBlow) {
  const std::vector<double> sound = sound_of(stretched_sheet(20, 4.0), 1e6);
  EXPECT_TRUE(std::ranges::all_of(sound, [](double sample) { return std::isfinite(sample); }));
}

TEST(StretchedVoices, AreDoubtedWhereTheirPartsTurnFar) {
  sound_maps::SoundMap map = stretched_sheet(20, 4.0);
  for (std::size_t mode = 0; mode < 20; ++mode) {
    map.stretching.rotation[mode * 21] = 1e5;
  }
  const auto doubts_after = [&](double speed) {
    Performance performance({map}, one_blow(speed), rate);
    (void)rendered(performance, rate / 10, 512);
    return performance.stage().report().doubts;
  };
  EXPECT_THAT(doubts_after(0.1), testing::IsEmpty());
  EXPECT_THAT(doubts_after(100.0), testing::ElementsAre(testing::AllOf(testing::StartsWith("body sheet: "),
                                                                       testing::HasSubstr("up to 0.1 rad"))));
}

TEST(StretchedVoices, StrikeEachOther) {
  const std::vector<sound_maps::SoundMap> maps = {stretched_sheet(20, 4.0), stretched_sheet(20, 4.0, "second")};
  const std::vector<double> apart = sound_of_two(maps, {0}, {}), touching = sound_of_two(maps, {0}, {{0, 1}});
  EXPECT_GT(level_of_difference(apart, touching), -10.0);
  EXPECT_GT(level_of_difference(
                touching, sound_of_two({without_stretching(maps[0]), without_stretching(maps[1])}, {0}, {{0, 1}})),
            -10.0);
}

TEST(StretchedVoices, DoNotTouchWhileTheyMoveTogether) {
  // The gap between equal points of equal bodies that are struck alike never changes.
  const std::vector<sound_maps::SoundMap> maps = {stretched_sheet(20, 4.0), stretched_sheet(20, 4.0, "second")};
  EXPECT_LT(level_of_difference(sound_of_two(maps, {0, 1}, {}), sound_of_two(maps, {0, 1}, {{0, 1}})), -90.0);
}

TEST(StretchedVoices, AreHeardInFullWhateverTheBudget) {
  const sound_maps::SoundMap map = stretched_sheet(40, 40.0);
  const Audience audience = audience_of({map});
  const auto voice_of = [&](const sound_maps::SoundMap& one) {
    return std::make_unique<SoundMapVoices>(shared_maps({one}), audience, rate, MapDetail{.budget = 1e-9});
  };
  const auto choices_of = [&](SoundMapVoices& voice) {
    voice.excite(0, std::get<drivers::Excitation>(drivers::event_of(one_blow(3.0).events[0], 0, 1, rate).action), 0);
    std::vector<double> sound(2 * rate);
    voice.render(sound, 0);
    return voice.take_choices();
  };
  const auto stretched = voice_of(map), linear = voice_of(without_stretching(map));
  const std::vector<MapChoice> with = choices_of(*stretched), without = choices_of(*linear);
  EXPECT_EQ(without[3].heard, 0U);
  EXPECT_EQ(with[3].heard, with[3].modes);
  EXPECT_GT(with[3].cost, 0.01) << "40 x 40 x 41 multiply-adds in an audio sample";
  EXPECT_EQ(with.back().heard, 0U) << "it is small by then";
}

}  // namespace idiophone::voices
