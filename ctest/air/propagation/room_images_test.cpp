// The image sources of a room: exact delays, levels and modes.

#include <gtest/gtest.h>

#include <algorithm>

#include "pulsating_sphere.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

ON_RANKS(1, 3);

/// The images of Allen and Berkley 1979, in their own numbering: (1 - 2 q) x + 2 m L, with |m - q| reflections at the
/// low wall and |m| at the high one.
TEST(Room, SendsEachImageWithItsDelayAndLevel) {
  constexpr int order = 3, rate = 44100;
  constexpr double width = 5.0;
  scene::Room room = room_of({3.1, 2.3, 2.7}, 0.0, order, false);
  const std::array<double, 6> absorption = {0.1, 0.3, 0.5, 0.2, 0.6, 0.4};
  for (std::size_t wall = 0; wall < 6; ++wall) {
    room.absorption.at(wall).fill(absorption.at(wall));
  }
  const Vector3 source(0.3, -1.2, 1.9), microphone(1.7, -0.1, 2.8);
  const scene::Scene scene = scene_in(room, rate, {microphone});
  const auto sounds = hear(scene, source, 3000, width);
  if (rank() != 0) {
    return;
  }
  const double speed = scene.radiation.air.speed;
  std::vector<double> expected(3000);
  const auto add_image = [&](const Vector3& image, double level) {
    const double way = (image - microphone).norm();
    const double strength = level * 4.0 * pi * sphere_radius * sphere_radius / (4.0 * pi * way) * rate / speed;
    for (std::size_t n = 0; n < expected.size(); ++n) {
      expected[n] += strength * slope_at(static_cast<double>(n) - way / speed * rate, width);
    }
  };
  struct Line {
    double place, level;
    int reflections;
  };
  std::array<std::vector<Line>, 3> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double corner = room.corner[static_cast<int>(axis)], x = source[static_cast<int>(axis)] - corner;
    for (int m = -order; m <= order; ++m) {
      for (int q = 0; q < 2; ++q) {
        const int low = std::abs(m - q), high = std::abs(m);
        const double level = std::pow(1.0 - absorption.at(2 * axis), 0.5 * low) *
                             std::pow(1.0 - absorption.at(2 * axis + 1), 0.5 * high);
        lines.at(axis).push_back(
            {corner + (1 - 2 * q) * x + 2 * m * room.size[static_cast<int>(axis)], level, low + high});
      }
    }
  }
  int images = 0;
  for (const Line& x : lines[0]) {
    for (const Line& y : lines[1]) {
      for (const Line& z : lines[2]) {
        if (x.reflections + y.reflections + z.reflections <= order) {
          add_image({x.place, y.place, z.place}, x.level * y.level * z.level);
          ++images;
        }
      }
    }
  }
  EXPECT_EQ(images, 63);
  const double loudest = *std::ranges::max_element(expected);
  for (std::size_t n = 0; n < expected.size(); ++n) {
    ASSERT_NEAR(sounds.at(0)[n], expected[n], 5e-4 * loudest) << n;
  }
}

ON_RANKS(1);

/// The loudest frequency near one, from the spectrum behind a window.
double loudest_near(std::vector<double> sound, double frequency, int rate) {
  for (std::size_t n = 0; n < sound.size(); ++n) {
    sound[n] *= 1.0 - std::cos(2.0 * pi * static_cast<double>(n) / static_cast<double>(sound.size()));
  }
  double found = 0.0, level = 0.0;
  for (double near = frequency - 8.0; near <= frequency + 8.0; near += 0.1) {
    if (const double here = std::abs(spectrum(sound, near, rate)); here > level) {
      found = near;
      level = here;
    }
  }
  return found;
}

TEST(Room, OfRigidWallsHasItsModes) {
  // Source and microphone are in the middle of the other two edges, where the first modes along these are silent.
  constexpr int order = 25, rate = 4000;
  const scene::Room room = room_of({1.5, 1.2, 0.9}, 0.0, order, false);
  const auto length = static_cast<std::size_t>(order * 0.9 / 343.0 * rate);  // until an image is missing
  for (int axis = 0; axis < 3; ++axis) {
    Vector3 source = room.centre(), microphone = room.centre();
    source[axis] -= 0.48 * room.size[axis];
    microphone[axis] += 0.45 * room.size[axis];
    const scene::Scene scene = scene_in(room, rate, {microphone});
    const auto sounds = hear(scene, source, pulse_middle + length, 2.0);
    const double exact = 0.5 * scene.radiation.air.speed / room.size[axis];
    EXPECT_NEAR(loudest_near(sounds.at(0), exact, rate), exact, 0.01 * exact) << axis;
  }
}

TEST(Room, AbsorbsInEachOctaveWhatTheDeckSays) {
  // The other walls absorb everything, so there is one reflection.
  constexpr int rate = 44100;
  scene::Room room = room_of({3, 3, 3}, 1.0, 1, false);
  room.absorption[4] = {0.1, 0.2, 0.4, 0.6, 0.8, 0.9};
  const Vector3 source(0.5, -0.5, 2.0), microphone(0.9, -0.5, 2.0);
  const auto reflected = hear(scene_in(room, rate, {microphone}), source, 3000, 1.5);
  room.absorption[4].fill(1.0);
  const auto direct = hear(scene_in(room, rate, {microphone}), source, 3000, 1.5);
  std::vector<double> echo(3000);
  std::ranges::transform(reflected.at(0), direct.at(0), echo.begin(), std::minus<>());
  const double levels = 0.4 / std::hypot(0.4, 3.0);
  for (std::size_t band = 0; band < 6; ++band) {
    const double frequency = 125.0 * std::exp2(band), share = 1.0 - std::array{0.1, 0.2, 0.4, 0.6, 0.8, 0.9}.at(band);
    const double ratio = std::abs(spectrum(echo, frequency, rate)) / std::abs(spectrum(direct.at(0), frequency, rate));
    EXPECT_NEAR(20.0 * std::log10(ratio / levels), 10.0 * std::log10(share), 0.5) << frequency;
  }
}

TEST(Room, IsLeftByNobody) {
  const scene::Scene scene = scene_in(room_of({5, 4, 3}, 0.2, 1, true), 8000, {{3, 1, 1}});
  EXPECT_THROW(hear(scene, {-1.5, -1.5, 1.0}, 10, 1.5), std::runtime_error);
  scene::Scene outside = scene;
  outside.listeners[0].receivers[0].position = {3, 3, 1};
  EXPECT_THROW(hear(outside, {-0.5, -1.5, 1.0}, 10, 1.5), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::propagation
