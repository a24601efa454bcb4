// Ways around several edges, one after the other.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "idiophone/air/radiation/bend.hpp"
#include "wave_spectrum.hpp"

namespace idiophone::radiation {
namespace {

using std::numbers::pi;

/// The edges of a wall along y from -50 m to 50 m.
/// @param profile  places (x, z) along its surface: its foot in front, the edges, its foot behind, m
EdgesInTurn wall(const std::vector<std::array<double, 2>>& profile) {
  EdgesInTurn way{.count = profile.size() - 2};
  const auto at = [&](std::size_t i) { return Vector3(profile[i][0], 0.0, profile[i][1]); };
  for (std::size_t i = 0; i < way.count; ++i) {
    const Vector3 face = (at(i) - at(i + 1)).normalized(), onwards = (at(i + 2) - at(i + 1)).normalized();
    const Vector3 normal = Vector3::UnitY().cross(face);
    const double angle = 2.0 * pi + std::atan2(onwards.dot(normal), onwards.dot(face));
    way.edges.at(i) = {at(i + 1) - 50.0 * Vector3::UnitY(), at(i + 1) + 50.0 * Vector3::UnitY(), face, normal, angle};
    if (i > 0) {
      way.over_face.at(i - 1) = true;
    }
  }
  return way;
}

const EdgesInTurn thick_wall = wall({{0, -9}, {0, 0}, {0.5, 0}, {0.5, -9}});
const EdgesInTurn house = wall({{0, -9}, {0, 0}, {0.5, 0.4}, {1, 0}, {1, -9}});

/// Two thin screens from z = -9 m to 0 at x = 0 and `apart`.
EdgesInTurn two_screens(double apart) {
  EdgesInTurn way{.count = 2};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3 at(i == 0 ? 0.0 : apart, 0.0, 0.0), half(0.0, 50.0, 0.0);
    way.edges.at(i) = {at - half, at + half, -Vector3::UnitZ(), -Vector3::UnitX(), 2.0 * pi};
  }
  return way;
}

EdgesInTurn reversed(const EdgesInTurn& way) {
  EdgesInTurn back = way;
  for (std::size_t i = 0; i < way.count; ++i) {
    back.edges.at(i) = way.edges.at(way.count - 1 - i).turned();
  }
  return back;
}

/// The first edges of a way.
EdgesInTurn only(EdgesInTurn way, std::size_t count) {
  way.count = count;
  way.over_face.at(1) = count == 3 && way.over_face.at(1);
  way.over_face.at(0) = count >= 2 && way.over_face.at(0);
  return way;
}

TEST(EdgesInTurn, AreTouchedOnTheShortestWay) {
  const Vector3 source(-1.0, 0.0, -2.0), receiver(1.6, 3.0, -0.7);
  EdgesInTurn skew = house;
  skew.edges[1].end.z() += 3.0;
  for (const EdgesInTurn& way : {thick_wall, house, skew}) {
    const std::span edges(way.edges.data(), way.count);
    const auto apexes = shortest_way(edges, source, receiver);
    const auto length = [&](const std::array<Vector3, most_in_turn>& corners) {
      double sum = (corners[0] - source).norm() + (receiver - corners.at(way.count - 1)).norm();
      for (std::size_t i = 1; i < way.count; ++i) {
        sum += (corners.at(i) - corners.at(i - 1)).norm();
      }
      return sum;
    };
    for (std::size_t i = 0; i < way.count; ++i) {
      EXPECT_NEAR((apexes.at(i) - edges[i].begin).cross(edges[i].direction()).norm(), 0.0, 1e-9);
      for (const double step : {-1e-3, 1e-3}) {
        auto moved = apexes;
        moved.at(i) += step * edges[i].direction();
        EXPECT_LT(length(apexes), length(moved));
      }
    }
  }
}

TEST(EdgesInTurn, AreReciprocal) {
  const Vector3 source(-1.0, 0.0, -2.0), receiver(1.6, 1.0, -0.7);
  for (const EdgesInTurn& way : {thick_wall, house, two_screens(0.7)}) {
    const Bend there = find_bend(way, source, receiver, sound_speed);
    const Bend back = find_bend(reversed(way), receiver, source, sound_speed);
    ASSERT_GT(there.gain, 0.0);
    EXPECT_NEAR(there.gain, back.gain, 1e-9);
    for (std::size_t i = 0; i < way.count; ++i) {
      for (std::size_t wave = 0; wave < 2; ++wave) {
        const EdgeWave &one = there.waves.at(i).at(wave), &other = back.waves.at(way.count - 1 - i).at(wave);
        EXPECT_NEAR(one.gain, other.gain, 1e-6);
        EXPECT_NEAR(one.delay, other.delay, 1e-6 * one.delay);
      }
    }
  }
}

/// Where the last edge comes into sight, its wave is half of that of the edges before alone.
void expect_continuous(const EdgesInTurn& way, const Vector3& source, double last_angle) {
  const DiffractingEdge last = way.edges.at(way.count - 1);
  const auto level = [&](double beyond) {
    const double angle = last_angle + beyond;  // from the horizontal, downwards
    const Vector3 receiver =
        Vector3(last.begin.x(), 0.0, last.begin.z()) + 2.0 * Vector3(std::cos(angle), 0.1, -std::sin(angle));
    const std::complex<double> all = spectrum_of(find_bend(way, source, receiver, sound_speed), 1000.0);
    const EdgesInTurn others = only(way, way.count - 1);
    return std::abs(all + (beyond < 0 ? spectrum_of(find_bend(others, source, receiver, sound_speed), 1000.0) : 0.0));
  };
  EXPECT_GT(level(1e-8), 0.0);
  EXPECT_NEAR(level(-1e-8) / level(1e-8), 1.0, 0.01);
}

TEST(EdgesInTurn, GoOnFromFewer) {
  const Vector3 source(-1.0, 0.0, -1.0);
  expect_continuous(thick_wall, source, 0.0);
  expect_continuous(two_screens(0.5), source, 0.0);
  expect_continuous(house, source, std::atan2(0.4, 0.5));
}

TEST(EdgesInTurn, ActNeitherBesideTheirEndsNorFarFromTheShadow) {
  const Vector3 source(-1.0, 0.0, -2.0);
  EXPECT_GT(find_bend(house, source, {1.6, 0.0, -0.7}, sound_speed).gain, 0.0);
  EXPECT_EQ(find_bend(house, source, {1.6, 300.0, -0.7}, sound_speed).gain, 0.0);
  EXPECT_EQ(find_bend(house, source, {1.0, 0.0, 3.0}, sound_speed).gain, 0.0);
}

/// Keller's coefficient of a rigid half-plane, for sqrt(k) = 1 (Geometrical theory of diffraction, JOSA 52, 1962).
double keller(double source_angle, double receiver_angle) {
  return (1.0 / std::cos(0.5 * (receiver_angle - source_angle)) +
          1.0 / std::cos(0.5 * (receiver_angle + source_angle))) /
         (2.0 * std::sqrt(2.0 * pi));
}

/// At high frequencies, the waves spread from each edge as Keller's rays do: sqrt(L/(s0 s1 s2)) over that without
/// edges.
TEST(EdgesInTurn, OfTwoScreensAreKellersAtHighFrequencies) {
  for (const double apart : {0.3, 1.0, 4.0}) {
    const Vector3 source(-1.0, 0.0, -1.5), receiver(apart + 0.8, 0.0, -2.0);
    const double before = source.norm(), after = std::hypot(0.8, 2.0), length = before + apart + after;
    const double source_angle = std::atan2(1.0, 1.5), receiver_angle = 2.0 * pi - std::atan2(0.8, 2.0);
    const double frequency = 2e5, wave_number = 2.0 * pi * frequency / sound_speed;
    const double expected = keller(source_angle, 1.5 * pi) * keller(0.5 * pi, receiver_angle) / wave_number *
                            std::sqrt(length / (before * apart * after));
    const double found = std::abs(spectrum_of(find_bend(two_screens(apart), source, receiver, sound_speed), frequency));
    EXPECT_NEAR(20.0 * std::log10(found / std::abs(expected)), 0.0, 0.3) << apart;
  }
}

/// A thick wall that gets thinner becomes a screen. Pierce's formula is up to 2.6 dB too loud there.
TEST(EdgesInTurn, OfAThinWallAreNearAScreen) {
  const Vector3 source(-1.0, 0.0, -1.0), receiver(1.2, 0.5, -0.8);
  const Bend thin = find_bend(wall({{0, -9}, {0, 0}, {1e-4, 0}, {1e-4, -9}}), source, receiver, sound_speed);
  const Bend screen = find_bend(only(two_screens(1.0), 1), source, receiver, sound_speed);
  for (const double frequency : {63.0, 250.0, 1000.0, 4000.0}) {
    const double ratio = std::abs(spectrum_of(thin, frequency)) / std::abs(spectrum_of(screen, frequency));
    EXPECT_NEAR(20.0 * std::log10(ratio), 1.3, 1.4) << frequency;
  }
}

}  // namespace
}  // namespace idiophone::radiation
