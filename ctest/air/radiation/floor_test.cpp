#include "idiophone/air/radiation/floor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

#include "idiophone/air/radiation/radiation.hpp"

namespace idiophone::radiation {
namespace {

/// A triangle at a height above z = 0 that faces a direction, padded.
surface::Emission source(double height, const Vector3& normal) {
  surface::Emission emission;
  emission.resize(8);
  emission.pressure[0] = 2.0;
  emission.area[0] = 1e-4;
  for (int axis = 0; axis < 3; ++axis) {
    emission.normal[axis][0] = normal[axis];
  }
  emission.centre[2][0] = height;
  return emission;
}

TEST(Floor, ReflectsASoundWithTheDelayAndLevelOfItsImage) {
  // A source 1 m above the floor that faces x, a receiver 4 m away and 2 m above it: 3 m down to the image across 4 m.
  const Medium air{.speed = 340.0, .rate = 48000};
  const ReceiverState receiver{.position = {4, 0, 2}};
  const surface::Emission emission = source(1.0, Vector3::UnitX());
  Paths direct, reflected;
  Arrivals first, second;
  find_paths(emission, receiver, air, direct);
  find_paths(emission, image(receiver, {.reflection = 0.9}), air, reflected);
  Huygens().radiate(emission, direct, first);
  Huygens().radiate(emission, reflected, second);
  EXPECT_NEAR(first.delay[0], std::sqrt(17.0) / 340.0 * 48000.0, 1e-9);
  EXPECT_NEAR(second.delay[0], 5.0 / 340.0 * 48000.0, 1e-9);
  EXPECT_NEAR(first.sound[0], 2e-4 / 17.0 * 4.0, 1e-16);
  EXPECT_NEAR(second.sound[0], 0.9 * 2e-4 / 25.0 * 4.0, 1e-16);
}

TEST(Floor, OfAnyPlaceAndDirectionMirrorsAllOfTheReceiver) {
  const Vector3 normal = Vector3(1, 2, 2) / 3.0;
  const ReflectingPlane floor{.at = {5, 0, -1}, .normal = normal, .reflection = -0.5};
  const ReceiverState receiver{
      .position = {6, 3, 2}, .velocity = {1, -2, 3}, .axis = {0, 0, 1}, .directivity = 0.5, .gain = 2.0};
  const ReceiverState mirror = image(receiver, floor);
  EXPECT_NEAR((mirror.position - floor.at).dot(normal), -(receiver.position - floor.at).dot(normal), 1e-14);
  EXPECT_NEAR((mirror.position - receiver.position).cross(normal).norm(), 0.0, 1e-14);
  EXPECT_NEAR(mirror.velocity.dot(normal), -receiver.velocity.dot(normal), 1e-14);
  EXPECT_NEAR(mirror.axis.norm(), 1.0, 1e-14);
  EXPECT_EQ(mirror.gain, -1.0);
  const ReceiverState again = image(mirror, floor);
  EXPECT_NEAR((again.position - receiver.position).norm(), 0.0, 1e-14);
  EXPECT_NEAR((again.axis - receiver.axis).norm(), 0.0, 1e-14);
}

TEST(Floor, IsHeardByAMicrophoneFromWhereItsReflectionComes) {
  // A cardioid on the floor's normal that looks up has its null straight below: it hears the source above it only.
  const ReceiverState up{.position = {0, 0, 1}, .axis = {0, 0, 1}, .directivity = 0.5};
  const surface::Emission emission = source(3.0, -Vector3::UnitZ());
  Paths paths;
  find_paths(emission, up, {}, paths);
  EXPECT_NEAR(paths.gain[0], 1.0, 1e-15);
  find_paths(emission, image(up, {}), {}, paths);
  EXPECT_NEAR(paths.gain[0], 0.0, 1e-15);
}

}  // namespace
}  // namespace idiophone::radiation
