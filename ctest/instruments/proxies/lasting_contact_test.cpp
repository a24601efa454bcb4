#include "idiophone/instruments/proxies/lasting_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "bodies.hpp"

namespace idiophone::proxies {
namespace {

constexpr int audio_rate = 44100;
constexpr int samples_of_step = 735;  // in a physics step of 1/60 s
const Vector3 step_impulse(0.0, 0.0, -1e-3);

TEST(LastingContact, EqualImpulsesMakeAConstantForce) {
  const Force force = lasting_contact(0, 0, Vector3::Zero(), step_impulse, samples_of_step, audio_rate);
  EXPECT_NEAR(std::accumulate(force.curve.begin(), force.curve.end(), 0.0) / audio_rate, 1.0, 1e-12);
  for (int i = 0; i < samples_of_step; ++i) {
    EXPECT_NEAR(force.curve[i] + force.curve[i + samples_of_step], 60.0, 1e-9);
  }
}

/// The largest sound of a ball of 16 facets that rolls for a second, after it has begun to.
double sound_of_rolling(auto make_force) {
  Engine engine({});
  engine.add({.name = "ball", .levels = {rubber_cube(3)}, .listener = {0.05, 0.05, 1.0}});
  for (int step = 0; step < 60; ++step) {
    const double angle = 2.0 * std::numbers::pi * step / 16.0;
    const Vector3 at(0.05 + 0.05 * std::cos(angle), 0.05 + 0.05 * std::sin(angle), 0.05);
    engine.add(make_force(std::int64_t{step} * samples_of_step, at));
  }
  std::vector<double> sound(audio_rate);
  engine.render(sound);
  double largest = 0.0;
  for (std::size_t i = 2205; i + 2205 < sound.size(); ++i) {
    largest = std::max(largest, std::abs(sound[i]));
  }
  return largest;
}

TEST(LastingContact, FacetedBallRollsWithoutClicks) {
  const double clicks = sound_of_rolling(
      [](std::int64_t start, const Vector3& at) { return impact(0, start, at, step_impulse, 5e-4, audio_rate); });
  const double smooth = sound_of_rolling([](std::int64_t start, const Vector3& at) {
    return lasting_contact(0, start, at, step_impulse, samples_of_step, audio_rate);
  });
  RecordProperty("click_in_dB", std::to_string(20.0 * std::log10(clicks / smooth)));
  EXPECT_GT(20.0 * std::log10(clicks / smooth), 40.0);
}

}  // namespace
}  // namespace idiophone::proxies
