// The power that a force radiates, against that of a mode which sounds alike in all directions.

#include "idiophone/instruments/sound_maps/radiated_power.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "ranks.hpp"
#include "vibrating_map.hpp"

namespace idiophone::sound_maps {
namespace {

constexpr double decay = 2.0;  // 1/s

/// A ball whose modes have these pressures at 1 m in all directions for a modal velocity of 1 m sqrt(kg)/s.
SoundMap ball(std::vector<double> frequencies, const std::vector<double>& pressures) {
  SoundMap map = map_of(
      radiation::sphere(0.1, 1), [](const Vector3& place) { return place; }, std::move(frequencies));
  map.material_decay.assign(map.modes(), decay);
  map.sphere = sphere_of_directions(4);
  for (const double pressure : pressures) {
    map.sphere.pressure.insert(map.sphere.pressure.end(), map.sphere.direction.size(), pressure);
  }
  return map;
}

/// Of a pressure of this amplitude at 1 m in all directions, W.
double power_of(double pressure, const SoundMap& map) {
  return 4.0 * std::numbers::pi * pressure * pressure / (2.0 * map.air_density * map.air_speed);
}

ON_RANKS(1);

TEST(RadiatedPower, AtResonanceTheDampingTakesTheWholeForce) {
  const SoundMap map = ball({400.0}, {3.0});
  const std::vector<double> participation = {0.5};
  const double velocity = 0.5 / (2.0 * decay);  // m sqrt(kg)/s
  const double power = radiated_power(map, participation, std::vector{400.0}).front();
  EXPECT_NEAR(power / power_of(3.0 * velocity, map), 1.0, 2e-3);  // terms of d/w
}

TEST(RadiatedPower, HalfOfItIsLeftWhereTheDecayHasPulledTheFrequencyAway) {
  const SoundMap map = ball({400.0}, {1.0});
  const std::vector<double> frequencies = {400.0, 400.0 + decay / (2.0 * std::numbers::pi)};
  const std::vector<double> power = radiated_power(map, std::vector{1.0}, frequencies);
  EXPECT_NEAR(power[1] / power[0], 0.5, 5e-3);
}

TEST(RadiatedPower, FallsByTwelveDecibelsAnOctaveBelowTheLowestMode) {
  const SoundMap map = ball({4000.0}, {1.0});
  const std::vector<double> power = radiated_power(map, std::vector{1.0}, std::vector{20.0, 40.0});
  EXPECT_NEAR(power[1] / power[0], 16.0, 0.5);
}

TEST(RadiatedPower, ModesInterfere) {
  const std::vector<double> participation = {1.0, 1.0};
  const std::vector<double> frequency = {400.0};
  const double one = radiated_power(ball({400.0}, {1.0}), std::vector{1.0}, frequency).front();
  EXPECT_NEAR(radiated_power(ball({400.0, 400.0}, {1.0, 1.0}), participation, frequency).front() / one, 4.0, 1e-9);
  EXPECT_NEAR(radiated_power(ball({400.0, 400.0}, {1.0, -1.0}), participation, frequency).front() / one, 0.0, 1e-9);
}

TEST(RadiatedPower, FrequenciesHaveAllPeaks) {
  const std::vector<double> frequencies = frequencies_with_peaks(ball({400.0, 777.0}, {1.0, 1.0}));
  EXPECT_TRUE(std::ranges::is_sorted(frequencies));
  EXPECT_THAT(frequencies, ::testing::Contains(777.0));
  EXPECT_NEAR(frequencies.front(), 200.0, 1e-9);
  EXPECT_EQ(frequencies.back(), 777.0);
}

}  // namespace
}  // namespace idiophone::sound_maps
