#include "idiophone/air/surface/surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "driven.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

ON_RANKS(1);

TEST(Surface, TranslatingTriangleHasPressureAreaNormalAndCentre) {
  const Vector3 velocity(1.0, -2.0, 3.0);
  Driven driven([&](const Vector3&, double t) -> Vector3 { return velocity * t; }, paper);
  driven.advance(120);
  const Emission& emission = driven.at(100);
  EXPECT_NEAR(emission.pressure[0], 415.03 * 3.0, 1e-8);  // eqs. 2 and 5
  EXPECT_NEAR(emission.area[0], 0.5e-4, 1e-16);           // eq. 3
  const Vector3 centre = velocity * driven.time(100) + Vector3(0.01, 0.01, 0.0) / 3.0;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(emission.normal[axis][0], axis == 2 ? 1.0 : 0.0, 1e-13);  // eq. 4
    EXPECT_NEAR(emission.centre[axis][0], centre[axis], 1e-14);
  }
}

TEST(Surface, RotatingTriangleTurnsItsNormalAndFeelsItsCentresVelocity) {
  const double rate = 2.0 * pi * 50.0;  // about the y axis through the origin
  const auto turn = [&](double t) { return Eigen::AngleAxisd(rate * t, Vector3::UnitY()).toRotationMatrix(); };
  Driven driven([&](const Vector3& X, double t) -> Vector3 { return turn(t) * X - X; }, paper);
  driven.advance(400);
  for (const int sample : {50, 200, 350}) {
    const Vector3 normal = turn(driven.time(sample)) * Vector3::UnitZ();
    const Emission& emission = driven.at(sample);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(emission.normal[axis][0], normal[axis], 1e-5);
    }
    EXPECT_NEAR(emission.area[0], 0.5e-4, 1e-9);
    // The centre swings about the axis at x = 1/300 m: into the plane's back.
    EXPECT_NEAR(emission.pressure[0], -415.03 * rate * 0.01 / 3.0, 1e-4);
  }
}

TEST(Surface, RestsAtItsFirstDisplacement) {
  Driven driven([](const Vector3&, double) -> Vector3 { return {0.5, -0.25, 2.0}; }, paper);
  driven.advance(40);
  for (const auto& emission : driven.emissions) {
    EXPECT_EQ(emission.pressure[0], 0.0);
    EXPECT_NEAR(emission.centre[2][0], 2.0, 1e-14);
  }
}

TEST(Surface, PadsWithTrianglesThatAreNotThere) {
  Driven driven([](const Vector3&, double t) -> Vector3 { return {t, t, t}; }, paper);
  driven.advance(20);
  ASSERT_EQ(driven.emission.pressure.size(), 8U);
  for (std::size_t padding = 1; padding < 8; ++padding) {
    EXPECT_EQ(driven.emission.pressure[padding], 0.0);
    EXPECT_EQ(driven.emission.area[padding], 0.0);
    EXPECT_EQ(driven.emission.normal[2][padding], 0.0);
    EXPECT_TRUE(std::isfinite(driven.emission.centre[0][padding]));
  }
}

/// Ripples in every direction, so that no two triangles emit alike.
Vector3 ripple(const Vector3& X, double t) {
  return 1e-4 * Vector3(std::sin(900.0 * X.x() + 30000.0 * t), std::cos(700.0 * X.y() - 20000.0 * t),
                        std::sin(800.0 * (X.x() + X.y()) + 50000.0 * t));
}

/// A strip of n triangles.
struct Strip {
  explicit Strip(Index n) {
    for (Index i = 0; i < n + 2; ++i) {
      reference.emplace_back(0.005 * i, 0.01 * (i % 2), 0.002 * (i % 3));
    }
    for (Index i = 0; i < n; ++i) {
      triangles.push_back(i % 2 == 0 ? std::array{i, i + 1, i + 2} : std::array{i + 1, i, i + 2});
    }
  }
  std::vector<Vector3> reference;
  std::vector<std::array<Index, 3>> triangles;
};

void expect_same_bits(const Emission& a, std::size_t i, const Emission& b, std::size_t j) {
  EXPECT_EQ(a.pressure[i], b.pressure[j]);
  EXPECT_EQ(a.area[i], b.area[j]);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(a.normal[axis][i], b.normal[axis][j]);
    EXPECT_EQ(a.centre[axis][i], b.centre[axis][j]);
  }
}

TEST(Surface, ATriangleGivesTheSameBitsAtAnyPlace) {
  constexpr double dc_loss = 0.01;
  const Strip strip(21);
  Driven whole(ripple, paper, strip.reference, strip.triangles, dc_loss);
  whole.advance(30);
  for (std::size_t number = 0; number < strip.triangles.size(); ++number) {
    std::vector<Vector3> reference;
    for (const Index vertex : strip.triangles[number]) {
      reference.push_back(strip.reference[vertex]);
    }
    Driven alone(ripple, paper, reference, {{0, 1, 2}}, dc_loss);
    alone.advance(30);
    expect_same_bits(whole.emission, number, alone.emission, 0);
    EXPECT_NE(alone.emission.pressure[0], 0.0);
  }
}

TEST(Surface, GoesOnFromASavedStateToTheBitAlsoInAnotherOrder) {
  constexpr double dc_loss = 0.05;
  const Strip strip(13);
  Driven straight(ripple, paper, strip.reference, strip.triangles, dc_loss);
  straight.advance(29);
  const auto rows = [](std::vector<Index> numbers) {
    const std::size_t count = numbers.size();
    return parallel::Rows(numbers, static_cast<std::int64_t>(count), MPI_COMM_SELF);
  };
  std::vector<Index> numbers(13), vertex_numbers(15);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::iota(vertex_numbers.begin(), vertex_numbers.end(), 0);
  support::MemoryArchive archive(MPI_COMM_SELF);
  straight.surface().archive(archive, rows(numbers), rows(vertex_numbers));
  straight.emitter().archive(archive, rows(numbers));
  straight.advance(1);

  // Resumed with triangles in reverse, as another partition might have them.
  archive.restore();
  auto triangles = strip.triangles;
  std::ranges::reverse(triangles);
  std::ranges::reverse(numbers);
  Surface resumed(triangles, strip.reference, paper);
  resumed.archive(archive, rows(numbers), rows(vertex_numbers));
  Emitter emitter(triangles, dc_loss);
  emitter.archive(archive, rows(numbers));
  for (int read = 1; read <= 6; ++read) {
    for (std::size_t vertex = 0; vertex < strip.reference.size(); ++vertex) {
      Vector3::Map(&resumed.displacements()[3 * vertex]) =
          ripple(strip.reference[vertex], (29.0 * 6.0 + read) / (44100.0 * 6.0));
    }
    resumed.read();
  }
  SurfaceMotion motion;
  resumed.take(motion);
  Emission emission;
  emitter.emit(motion, emission);
  for (std::size_t number = 0; number < 13; ++number) {
    expect_same_bits(emission, 12 - number, straight.emission, number);
  }
}

TEST(Surface, LetsNotANumberThrough) {
  Driven driven([](const Vector3&, double t) -> Vector3 { return {0, 0, t > 1e-4 ? std::nan("") : 0.0}; }, paper);
  driven.advance(20);
  EXPECT_TRUE(std::isnan(driven.emission.pressure[0]));
}

TEST(Surface, MayBeEmpty) {
  Surface surface({}, {}, paper);
  surface.start();
  for (int read = 0; read < 6; ++read) {
    surface.read();
  }
  SurfaceMotion motion;
  surface.take(motion);
  Emission emission;
  Emitter({}, 0.0).emit(motion, emission);
  EXPECT_TRUE(emission.pressure.empty());
}

TEST(Surface, SaysWhatIsWrongWithItsArguments) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  const auto make = [](const std::vector<std::array<Index, 3>>& triangles, const std::vector<Vector3>& reference,
                       const Sampling& sampling) { return [=] { Surface(triangles, reference, sampling); }; };
  EXPECT_THAT(make({{0, 1, 3}}, corners, paper), ThrowsMessage<std::invalid_argument>(HasSubstr("vertex 3")));
  EXPECT_THAT(make({{0, 1, 2}, {0, 1, 1}}, corners, paper),
              ThrowsMessage<std::invalid_argument>(HasSubstr("triangle 1")));
  EXPECT_THAT(make({{0, 1, 2}}, {{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}, paper),
              ThrowsMessage<std::invalid_argument>(HasSubstr("not finite")));
  Sampling sampling = paper;
  sampling.steps_per_read = 5;
  EXPECT_THAT(make({{0, 1, 2}}, corners, sampling), ThrowsMessage<std::invalid_argument>(HasSubstr("divisor")));
  sampling = paper;
  sampling.max_frequency = 30000.0;
  EXPECT_THAT(make({{0, 1, 2}}, corners, sampling), ThrowsMessage<std::invalid_argument>(HasSubstr("max_frequency")));
}

TEST(Surface, RefusesCallsOutOfTurn) {
  Surface surface({{0, 1, 2}}, corners, paper);
  surface.start();
  SurfaceMotion motion;
  EXPECT_THROW(surface.take(motion), std::logic_error);
  surface.read();
  const parallel::Rows triangle(std::vector<Index>{0}, 1, MPI_COMM_SELF);
  const parallel::Rows vertices(std::vector<Index>{0, 1, 2}, 3, MPI_COMM_SELF);
  support::MemoryArchive archive(MPI_COMM_SELF);
  EXPECT_THROW(surface.archive(archive, triangle, vertices), std::logic_error);
  for (int read = 1; read < 6; ++read) {
    surface.read();
  }
  EXPECT_THROW(surface.read(), std::logic_error);
  surface.take(motion);
  EXPECT_NO_THROW(surface.archive(archive, triangle, vertices));
}

}  // namespace
}  // namespace idiophone::surface
