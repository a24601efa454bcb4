// The sound of a blow, against the motion of a single oscillator.

#include "idiophone/instruments/sound_maps/blow.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "idiophone/instruments/sound_maps/resonators.hpp"
#include "ranks.hpp"
#include "vibrating_map.hpp"

namespace idiophone::sound_maps {
namespace {

using std::numbers::pi;
constexpr int rate = 44100;

/// One triangle that moves along z, more at its corner at x = 1; heard with a phase.
sound_maps::SoundMap one_mode(double frequency, double decay, std::complex<double> pressure) {
  const radiation::Solid triangle{.triangles = {{0, 1, 2}}, .vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  sound_maps::SoundMap map = map_of(triangle,
                                    [](const Vector3& place) -> Vector3 {
                                      return {0, 0, 1 + place[0]};
                                    },
                                    {frequency});
  map.material_decay = {0.75 * decay};
  map.radiation_decay = {0.25 * decay};
  map.listeners = {{.name = "ear", .position = {0, 0, 1}, .delay = 0.00123456, .pressure = {pressure}}};
  return map;
}

ON_RANKS(1);

TEST(Participation, IsLinearInATriangleAndTakesTheNearestPoint) {
  const sound_maps::SoundMap map = one_mode(100, 1, 1.0);
  const auto along_z = [&](const Vector3& at) { return participation(map, at, Vector3::UnitZ()).at(0); };
  EXPECT_NEAR(along_z({0.25, 0.25, 0}), 1.25, 1e-6);
  EXPECT_NEAR(along_z({0.25, 0.25, 0.3}), 1.25, 1e-6) << "above it";
  EXPECT_NEAR(along_z({0.5, -7, 0}), 1.5, 1e-6) << "beside it";
  EXPECT_NEAR(along_z({3, 0, 0}), 2, 1e-6) << "beyond a corner";
  EXPECT_NEAR(along_z({1, 1, 0}), 1.5, 1e-6) << "beyond the long side";
  EXPECT_NEAR(participation(map, {0, 0, 0}, {0.6, 0, 0.8}).at(0), 0.8, 1e-6);
}

/// Modal velocity of an oscillator after a half-sine force sin(pi t/T), by superposition of impulse responses, less
/// that of an oscillator that follows the force: its rise over w^2, after a low-pass of the oscillator's frequency.
double heard_velocity_at(double time, double frequency, double decay, double duration) {
  const double w = 2 * pi * frequency;
  const double damped = std::sqrt(w * w - decay * decay);
  constexpr int steps = 20000;
  double velocity = 0.0, smooth = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double then = (i + 0.5) / steps * duration;
    const double t = time - then;
    if (t > 0) {
      const double impulse = std::sin(pi * then / duration) / steps * duration;
      velocity += impulse * std::exp(-decay * t) * (std::cos(damped * t) - decay / damped * std::sin(damped * t));
      smooth += impulse * damped * std::exp(-damped * t);
    }
  }
  const double force = time > 0 && time < duration ? std::sin(pi * time / duration) : 0.0;
  return velocity - damped * (force - smooth) / (w * w);
}

TEST(SoundOfABlow, IsThatOfADampedOscillator) {
  constexpr double duration = 0.7e-3;
  for (const double decay : {3.0, 500.0}) {
    const sound_maps::SoundMap map = one_mode(1234.5, decay, 2.0);
    const Blow blow{.at = {0, 0, 0},
                    .direction = Vector3::UnitZ(),
                    .force = [](double time) { return 5 * std::sin(pi * time / duration); },
                    .duration = duration};
    const std::vector<double> sound = sound_of(blow, map, 0, rate, 400);
    for (const std::size_t sample : {0, 40, 54}) {
      EXPECT_EQ(sound[sample], 0) << "before it arrives";
    }
    for (const std::size_t sample : {60, 80, 90, 150, 399}) {
      const double time = static_cast<double>(sample) / rate - map.listeners[0].delay;
      EXPECT_NEAR(sound[sample], 10 * heard_velocity_at(time, 1234.5, decay, duration), 1e-6) << sample;
    }
  }
}

TEST(SoundOfABlow, HasThePhaseOfThePressure) {
  sound_maps::SoundMap map = one_mode(1000, 0, {0.0, 1.0});
  map.listeners[0].delay = 0.001;
  const Blow impulse{
      .at = {0, 0, 0}, .direction = Vector3::UnitZ(), .force = [](double) { return 1e6; }, .duration = 1e-6};
  const std::vector<double> sound = sound_of(impulse, map, 0, rate, 200);
  for (const std::size_t sample : {50, 51, 60, 199}) {
    const double time = static_cast<double>(sample) / rate - 0.001 - 0.5e-6;
    EXPECT_NEAR(sound[sample], -std::sin(2 * pi * 1000 * time), 0.004);
  }
}

TEST(SoundOfABlow, IsSilentUnderAConstantForce) {
  const sound_maps::SoundMap map = one_mode(1000, 100, {1.0, 2.0});
  const Blow load{.direction = Vector3::UnitZ(), .force = [](double) { return 1.0; }, .duration = 0.4};
  const std::vector<double> sound = sound_of(load, map, 0, rate, 16000);
  Resonators resonators(map, participation(map, load.at, load.direction), 0, rate);
  double stepped = 0.0;
  for (int i = 0; i < 16000; ++i) {
    stepped = resonators.step(1.0);
  }
  EXPECT_GT(std::abs(sound[60]), 1e-5);
  EXPECT_NEAR(sound.back(), 0, 1e-12);
  EXPECT_NEAR(stepped, 0, 1e-12);
}

TEST(SoundOfABlow, LeavesOutWhatTheRateCannotHold) {
  const sound_maps::SoundMap map = one_mode(5000, 1, 1.0);
  const Blow blow{.direction = Vector3::UnitZ(), .force = [](double) { return 1.0; }, .duration = 1e-3};
  EXPECT_THAT(sound_of(blow, map, 0, 8000, 100), ::testing::Each(0.0));
  EXPECT_GT(sound_of(blow, map, 0, rate, 100).back(), -1.0);
}

}  // namespace
}  // namespace idiophone::sound_maps
