// A small surface emits pulses; what the ears hear is known in closed form (O'Brien 2001, eqs. 10 and 11).

#include "idiophone/air/propagation/ears.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "checkpointed.hpp"
#include "idiophone/scene/scene.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;

constexpr double pressure = 3.0;      // Pa
constexpr double area = 2e-4;         // m2
constexpr std::size_t samples = 200;  // that are taken

/// A scene whose listeners, each with the receivers of one list, hear in the open.
scene::Scene scene_with(const std::vector<std::vector<Vector3>>& listeners) {
  scene::Scene scene;
  scene.audio.rate = 8000;
  scene.radiation.model = scene::RadiationModel::huygens;  // its sound is the pressure, not its rate of change
  scene.radiation.visibility.reset();
  for (const auto& positions : listeners) {
    auto& listener = scene.listeners.emplace_back();
    listener.name = "listener";
    for (const Vector3& position : positions) {
      listener.receivers.push_back({.channel = "channel", .position = position});
    }
  }
  return scene;
}

/// One triangle at the origin that faces x, on each of the ranks that emit; none elsewhere.
surface::Emission triangle(double strength) {
  surface::Emission emission;
  emission.resize(padded(1));
  emission.pressure[0] = emission.surface_pressure[0] = strength;
  emission.area[0] = area;
  emission.normal[0][0] = 1.0;
  return emission;
}

/// Audio samples in which sound travels a distance, m.
double travel_time(const scene::Scene& scene, double distance) {
  return distance * scene.audio.rate / scene.radiation.air.speed;
}

double sum(const std::vector<double>& sound) {
  return std::accumulate(sound.begin(), sound.end(), 0.0);
}

/// Mean audio sample of a sound, weighted by its values.
double centroid(const std::vector<double>& sound) {
  double moment = 0.0;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    moment += static_cast<double>(i) * sound[i];
  }
  return moment / sum(sound);
}

/// What the first listener hears of pulses that all ranks emit at an audio sample; nothing on other ranks than 0.
std::vector<double> hear_pulse(const scene::Scene& scene, std::int64_t sample) {
  Ears ears(scene, 0, 1);
  ears.hear(sample, triangle(pressure / ranks()), nullptr);
  const auto sounds = ears.take(samples, MPI_COMM_WORLD);
  return sounds.at(0);
}

ON_RANKS(1, 3);

TEST(Ears, HearAPulseWithOneOverDistanceAfterItsTravelTime) {
  for (const double distance : {0.5, 1.0, 4.0}) {
    const scene::Scene scene = scene_with({{Vector3(distance, 0, 0)}});
    const auto sound = hear_pulse(scene, 7);
    if (rank() == 0) {
      ASSERT_EQ(sound.size(), samples);
      EXPECT_NEAR(sum(sound), pressure * area / distance, 1e-7 * pressure * area);
      EXPECT_NEAR(centroid(sound), 7 + travel_time(scene, distance), 1e-5);
    }
  }
}

TEST(Ears, HearTheCosineOfTheAngleAndNothingBehindTheTriangle) {
  const auto aside = hear_pulse(scene_with({{Vector3(0.6, 0.8, 0)}}), 0);
  const auto behind = hear_pulse(scene_with({{Vector3(-1, 0, 0)}}), 0);
  if (rank() == 0) {
    EXPECT_NEAR(sum(aside), 0.6 * pressure * area, 1e-7 * pressure * area);
    EXPECT_EQ(sum(behind), 0.0);
  }
}

TEST(Ears, HearTheFloorsEchoFromTheImage) {
  constexpr double x = 1.0, height = 1.0, reflection = 0.5;
  scene::Scene scene = scene_with({{Vector3(x, 0, 0)}});
  scene.radiation.floor = {.at = Vector3(0, 0, -height), .direction = Vector3::UnitZ(), .reflection = reflection};
  auto echo = hear_pulse(scene, 0);
  scene.radiation.floor.reset();
  const auto direct = hear_pulse(scene, 0);
  if (rank() == 0) {
    std::ranges::transform(echo, direct, echo.begin(), std::minus<>());
    const double way = std::hypot(x, 2 * height);
    EXPECT_NEAR(sum(echo), reflection * pressure * area * (x / way) / way, 1e-7 * pressure * area);
    EXPECT_NEAR(centroid(echo), travel_time(scene, way), 1e-5);
  }
}

TEST(Ears, GiveAListenersReceiversSideBySide) {
  const scene::Scene scene = scene_with({{Vector3(1, 0, 0)}, {Vector3(2, 0, 0), Vector3(4, 0, 0)}});
  Ears ears(scene, 0, 1);
  EXPECT_EQ(ears.ear_count(), 3U);
  EXPECT_EQ(ears.positions(0).at(2), Vector3(4, 0, 0));
  ears.hear(0, triangle(pressure / ranks()), nullptr);
  const auto sounds = ears.take(samples, MPI_COMM_WORLD);
  if (rank() != 0) {
    return;
  }
  ASSERT_EQ(sounds.size(), 2U);
  ASSERT_EQ(sounds[1].size(), 2 * samples);
  std::vector<double> left, right;
  for (std::size_t i = 0; i < samples; ++i) {
    left.push_back(sounds[1][2 * i]);
    right.push_back(sounds[1][2 * i + 1]);
  }
  EXPECT_NEAR(sum(left), pressure * area / 2, 1e-7 * pressure * area);
  EXPECT_NEAR(sum(right), pressure * area / 4, 1e-7 * pressure * area);
}

class EarsOfModel : public ::testing::TestWithParam<scene::RadiationModel> {};

/// A receiver at the triangle hears the next emission from the first audio sample on that is not yet final, or from the
/// one after it, where a filter begins with a zero.
TEST_P(EarsOfModel, KnowWhichSamplesAreFinal) {
  scene::Scene scene = scene_with({{Vector3(1e-3, 0, 0)}});
  scene.radiation.model = GetParam();
  Ears ears(scene, 0, 1);
  constexpr std::int64_t sample = 70;
  const std::int64_t final_samples = ears.final_before(sample - 1);
  ears.hear(sample, triangle(pressure), nullptr);
  const auto sounds = ears.take(samples, MPI_COMM_WORLD);
  if (rank() == 0) {
    const auto first = std::ranges::find_if(sounds.at(0), [](double value) { return value != 0.0; });
    EXPECT_GE(first - sounds[0].begin(), final_samples);
    EXPECT_LE(first - sounds[0].begin(), final_samples + 1);
  }
}

TEST_P(EarsOfModel, GoOnFromAnArchiveWithTheSameBitsOnAnyRanks) {
  scene::Scene scene = scene_with({{Vector3(1, 0.1, 0)}, {Vector3(0.7, 0, 0), Vector3(2, 1, 0)}});
  scene.radiation.model = GetParam();
  const auto emit = [](Ears& ears, std::int64_t begin, std::int64_t end, double strength) {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      ears.hear(sample, triangle(strength / static_cast<double>(sample + 1)), nullptr);
    }
  };
  const Folder folder;
  const parallel::Rows triangles(std::vector<Index>{rank()}, ranks(), MPI_COMM_WORLD);
  Ears ears(scene, 0, 1);
  emit(ears, 0, 80, pressure);
  (void)ears.take(10, MPI_COMM_WORLD);
  const auto checkpoint = save(folder, ears, triangles);
  emit(ears, 80, 110, pressure);
  const auto expected = ears.take(samples, MPI_COMM_WORLD);

  Ears resumed(scene, 0, 1);
  restore(checkpoint, MPI_COMM_WORLD, resumed, triangles);
  emit(resumed, 80, 110, pressure);
  EXPECT_EQ(resumed.take(samples, MPI_COMM_WORLD), expected);

  if (rank() == 0) {  // alone: microphones remember nothing of triangles
    Ears alone(scene, 0, 1);
    restore(checkpoint, MPI_COMM_SELF, alone, triangles);
    for (int i = 0; i < ranks(); ++i) {
      emit(alone, 80, 110, pressure);
    }
    EXPECT_EQ(alone.take(samples, MPI_COMM_SELF), expected);
  }
  barrier();
}

INSTANTIATE_TEST_SUITE_P(Models, EarsOfModel,
                         ::testing::Values(scene::RadiationModel::huygens, scene::RadiationModel::rayleigh,
                                           scene::RadiationModel::kirchhoff));

}  // namespace
}  // namespace idiophone::propagation
