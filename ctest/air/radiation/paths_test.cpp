#include "idiophone/air/radiation/paths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace idiophone::radiation {
namespace {

/// Paths from one triangle at a place, its normal along z, to a receiver.
Paths paths_from(const Vector3& centre, const ReceiverState& receiver, const Medium& air = {}) {
  surface::Emission emission;
  emission.resize(8);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    emission.centre[axis][2] = centre[axis];
  }
  emission.normal[2][2] = 1.0;
  Paths paths;
  find_paths(emission, receiver, air, paths);
  return paths;
}

TEST(Paths, AreStraight) {
  const Paths paths = paths_from({1, 1, 1}, {.position = {2, 3, 3}}, {.speed = 300.0, .rate = 48000});
  EXPECT_NEAR(paths.distance[2], 3.0, 1e-15);
  EXPECT_NEAR(paths.cosine[2], 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(paths.delay[2], 480.0, 1e-12);
  EXPECT_EQ(paths.gain[2], 1.0);
}

TEST(Paths, MeetAMovingReceiverWhereItThenIs) {
  const Medium air{.speed = 340.0, .rate = 44100};
  const ReceiverState receiver{.position = {3, -4, 12}, .velocity = {-60, 80, 20}};
  const Vector3 centre(0.2, -0.1, 0.4);
  const Paths paths = paths_from(centre, receiver, air);
  const double time = paths.delay[2] / air.rate;
  const Vector3 way = receiver.position + receiver.velocity * time - centre;
  EXPECT_NEAR(paths.distance[2], air.speed * time, 1e-12);
  EXPECT_NEAR(way.norm(), air.speed * time, 1e-12);
  EXPECT_NEAR(paths.cosine[2], way.z() / way.norm(), 1e-14);
}

TEST(Paths, KnowWhereAMicrophoneLooks) {
  const Vector3 centre(0, 0, 0);
  const auto gain = [&](double directivity, double degrees, double strength = 1.0) {
    const double angle = degrees * std::numbers::pi / 180.0;
    // The source is seen in the direction -z.
    return paths_from(centre, {.position = {0, 0, 2},
                               .axis = {std::sin(angle), 0, -std::cos(angle)},
                               .directivity = directivity,
                               .gain = strength})
        .gain[2];
  };
  EXPECT_NEAR(gain(0.5, 0), 1.0, 1e-15);
  EXPECT_NEAR(gain(0.5, 90), 0.5, 1e-15);
  EXPECT_NEAR(gain(0.5, 180), 0.0, 1e-15);
  EXPECT_NEAR(gain(1.0, 60), 0.5, 1e-15);
  EXPECT_NEAR(gain(1.0, 180), -1.0, 1e-15);
  EXPECT_EQ(gain(0.0, 77, 0.25), 0.25);
}

TEST(Paths, StayFiniteAtATrianglesCentre) {
  const Paths paths = paths_from({1, 2, 3}, {.position = {1, 2, 3}, .directivity = 0.5});
  EXPECT_EQ(paths.distance[2], smallest_distance);
  EXPECT_EQ(paths.cosine[2], 0.0);
  EXPECT_EQ(paths.gain[2], 0.5);
}

TEST(Medium, HasToCarrySound) {
  EXPECT_THROW(Medium({.speed = 0.0}).validate(), std::invalid_argument);
  EXPECT_THROW(Medium({.rate = 0}).validate(), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::radiation
