#include "idiophone/air/surface/surface_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "idiophone/air/surface/emitter.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

using Field = SurfacePressure::Field;

constexpr double metres_per_sample = 343.0 / 44100.0;

/// Pressure after so many audio samples in which P, the same at all triangles, rises by 1 Pa each.
std::vector<double> after_ramp(Field field, const std::vector<double>& radii, int samples) {
  SurfacePressure air(field, radii, metres_per_sample);
  std::vector<double> before(padded(radii.size())), now(before), pressure(before);
  air.start(before);
  for (int i = 1; i <= samples; ++i) {
    now.assign(now.size(), i);
    air.step(before, now, pressure);
    before = now;
  }
  return pressure;
}

ON_RANKS(1);

TEST(SurfacePressure, IsExactForARamp) {
  // A P that rises as T = c t/a makes p = 1 - exp(-T) and [1 - exp(-T) (cos T - sin T)]/2.
  for (const double radius : {2e-4, 0.01, 0.3, 50.0}) {
    const double pace = metres_per_sample / radius;
    for (const int samples : {1, 7, 60}) {
      const double time = pace * samples;
      const double scale = 1.0 / pace;
      EXPECT_NEAR(after_ramp(Field::pulsating, {radius}, samples)[0], -std::expm1(-time) * scale, 1e-11 * samples);
      EXPECT_NEAR(after_ramp(Field::oscillating, {radius}, samples)[0],
                  (1.0 - std::exp(-time) * (std::cos(time) - std::sin(time))) / 2.0 * scale, 1e-11 * samples);
    }
  }
}

TEST(SurfacePressure, IsThePlaneWavesByDefault) {
  SurfacePressure air;
  const std::vector<double> before(8, 1.0), now(8, 3.0);
  std::vector<double> pressure(8);
  air.start(before);
  air.step(before, now, pressure);
  EXPECT_EQ(pressure, now);
  parallel::ArchiveRow row(parallel::ArchiveRow::Action::count);
  air.archive(0, row);
  EXPECT_EQ(row.count(), 0);
}

TEST(SurfacePressure, IsNothingAfterAnEternityAtOneSpeed) {
  for (const Field field : {Field::pulsating, Field::oscillating}) {
    SurfacePressure air(field, {0.01, 0.2}, metres_per_sample);
    const std::vector<double> steady = {3.0, -2.0, 0, 0, 0, 0, 0, 0};
    std::vector<double> pressure(8);
    air.start(steady);
    air.step(steady, steady, pressure);
    EXPECT_NEAR(pressure[0], 0.0, 1e-14);
    EXPECT_NEAR(pressure[1], 0.0, 1e-14);
  }
}

TEST(SurfacePressure, GivesATriangleTheSameBitsInAnyLane) {
  const auto pressures = after_ramp(Field::oscillating, std::vector<double>(13, 0.017), 9);
  for (std::size_t i = 1; i < 13; ++i) {
    EXPECT_EQ(pressures[i], pressures[0]);
  }
}

TEST(SurfacePressure, GoesOnInAnEmitterFromASavedState) {
  const std::vector<std::array<Index, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto emitter = [&] {
    return Emitter(triangles, 0.1, SurfacePressure(Field::oscillating, {0.01, 0.02}, metres_per_sample));
  };
  SurfaceMotion motion{std::vector<double>(8), std::vector<double>(SurfaceMotion::position_length(4))};
  const auto push = [&](Emitter& which, Emission& emission, double pressure) {
    motion.pressure = {pressure, -2.0 * pressure, 0, 0, 0, 0, 0, 0};
    which.emit(motion, emission);
  };
  Emitter straight = emitter();
  Emission emission, resumed_emission;
  straight.start(motion);
  push(straight, emission, 1.0);
  push(straight, emission, 0.3);
  const parallel::Rows rows(std::vector<Index>{0, 1}, 2, MPI_COMM_SELF);
  support::MemoryArchive archive(MPI_COMM_SELF);
  straight.archive(archive, rows);
  archive.restore();
  Emitter resumed = emitter();
  resumed.archive(archive, rows);
  push(straight, emission, 0.7);
  push(resumed, resumed_emission, 0.7);
  EXPECT_EQ(resumed_emission.surface_pressure, emission.surface_pressure);
  EXPECT_NE(emission.surface_pressure[0], emission.pressure[0]);
}

TEST(SurfacePressure, RefusesRadiiThatAreNone) {
  for (const double radius : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(SurfacePressure(Field::pulsating, {0.1, radius}, metres_per_sample), std::invalid_argument);
  }
}

}  // namespace
}  // namespace idiophone::surface
