#include "idiophone/air/surface/emitter.hpp"

#include <gmock/gmock.h>

#include "driven.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

ON_RANKS(1);

TEST(DcBlock, ThePapersLossIsMinusThreeDecibelsAt700Hz) {
  for (const double frequency : {70.0, 700.0, 5000.0}) {
    // Eq. 9 is H(z) = (1 - 1/z)/(1 - (1 - alpha)/z).
    const auto delay = std::exp(std::complex(0.0, -2.0 * pi * frequency / 44100.0));
    const auto expected = (1.0 - delay) / (1.0 - 0.9 * delay);
    EXPECT_LT(std::abs(pressure_response(frequency, paper, 0.1) - expected), 2e-3) << frequency;
  }
  EXPECT_NEAR(decibels(pressure_response(702.0, paper, 0.1)), -3.0, 0.5);
}

TEST(DcBlock, RemovesTheConstantPressureOfASteadyFlight) {
  Driven driven([](const Vector3&, double t) -> Vector3 { return {0, 0, 3.0 * t}; }, paper, corners, {{0, 1, 2}}, 0.1);
  driven.advance(300);
  EXPECT_NEAR(driven.at(290).pressure[0], 0.0, 1e-9);
  EXPECT_GT(driven.at(0).pressure[0], 100.0);
}

TEST(DcBlock, HearsNothingOfASteadyFlightThatHasAlwaysBeen) {
  const Vector3 velocity(1.0, 2.0, 3.0);
  Surface surface({{0, 1, 2}}, corners, paper);
  Emitter emitter({{0, 1, 2}}, 0.1);
  std::ranges::fill(surface.displacements(), 0.0);
  std::vector<double> velocities;
  for (int vertex = 0; vertex < 3; ++vertex) {
    velocities.insert(velocities.end(), velocity.begin(), velocity.end());
  }
  emitter.start(surface.start(velocities));
  SurfaceMotion motion;
  Emission emission;
  for (int read = 1; read <= 20 * paper.reads_per_sample(); ++read) {
    const Vector3 place = velocity * read / (paper.rate * static_cast<double>(paper.reads_per_sample()));
    for (std::size_t i = 0; i < 9; ++i) {
      surface.displacements()[i] = place[i % 3];
    }
    surface.read();
    if (read % paper.reads_per_sample() == 0) {
      surface.take(motion);
      emitter.emit(motion, emission);
      EXPECT_NEAR(emission.pressure[0], 0.0, 1e-9);
    }
  }
}

/// A triangle of 0.5 m2 and a point beside it, or the other way round.
SurfaceMotion triangle_and_point(bool triangle_is_first) {
  SurfaceMotion motion{.pressure = std::vector<double>(padded(2)),
                       .position = std::vector<double>(SurfaceMotion::position_length(6))};
  const std::size_t first = triangle_is_first ? 0 : 9;
  motion.position[first + 3] = 1.0;
  motion.position[first + 7] = 1.0;
  return motion;
}

TEST(Emitter, TrianglesThatBecomePointsFadeOutWhileOthersFadeInAlsoAfterARestart) {
  const std::vector<std::array<Index, 3>> triangles = {{0, 1, 2}, {3, 4, 5}};
  const std::vector<Index> ids = {0, 1};
  const parallel::Rows rows(ids, 2, MPI_COMM_WORLD);
  Emitter emitter(triangles, 0.0, {}, 0.25);
  Emission emission;
  emitter.start(triangle_and_point(true));
  emitter.emit(triangle_and_point(true), emission);
  EXPECT_EQ(emission.area[0], 0.5);
  EXPECT_EQ(emission.area[1], 0.0);
  for (const double heard : {0.15625, 0.5, 0.84375, 1.0, 1.0}) {  // 3 p^2 - 2 p^3 of p = 1/4, 1/2, ...
    support::MemoryArchive archive(MPI_COMM_WORLD);
    emitter.archive(archive, rows);
    archive.restore();
    Emitter restored(triangles, 0.0, {}, 0.25);
    restored.archive(archive, rows);
    for (Emitter* each : {&emitter, &restored}) {
      each->emit(triangle_and_point(false), emission);
      EXPECT_DOUBLE_EQ(emission.area[0], 0.5 * (1.0 - heard));
      EXPECT_DOUBLE_EQ(emission.area[1], 0.5 * heard);
      EXPECT_EQ(emission.normal[2][0], 1.0);
    }
  }
}

TEST(Emitter, SaysWhatIsWrongWithItsLoss) {
  EXPECT_THAT(
      [] {
        Emitter({{0, 1, 2}}, 1.0);
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("dc_loss")));
}

}  // namespace
}  // namespace idiophone::surface
