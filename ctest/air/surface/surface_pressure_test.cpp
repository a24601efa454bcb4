#include "idiophone/air/surface/surface_pressure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "idiophone/air/surface/emitter.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

using Field = SurfacePressure::Field;

constexpr double metres_per_sample = 343.0 / 44100.0;

/// Pressure after so many audio samples, in which P, the same at all triangles, follows a function of the audio sample.
template <class PlaneWave>
std::vector<double> after(int samples, Field field, const std::vector<double>& radii, const PlaneWave& plane_wave) {
  SurfacePressure air(field, radii, metres_per_sample);
  std::vector<double> before(padded(radii.size()), plane_wave(0)), now(before), pressure(before);
  air.start(before);
  for (int i = 1; i <= samples; ++i) {
    now.assign(now.size(), plane_wave(i));
    air.step(before, now, pressure);
    before = now;
  }
  return pressure;
}

std::vector<double> after_ramp(Field field, const std::vector<double>& radii, int samples) {
  return after(samples, field, radii, [](int sample) { return sample; });
}

/// Of a sphere on which P is 1 and harmonic, where it moves the air s = i k a.
std::complex<double> harmonic(Field field, std::complex<double> s) {
  return field == Field::pulsating ? s / (s + 1.0) : (s * s + s) / (s * s + 2.0 * s + 2.0);
}

/// Error for a harmonic P of 1 Pa with k a = 1 when it has lasted, Pa.
double harmonic_error(Field field, int samples_in_period) {
  const double angle = 2 * std::numbers::pi / samples_in_period;
  const std::vector<double> radii = {metres_per_sample / angle};
  double largest = 0.0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const int samples = 10 * samples_in_period + quarter * samples_in_period / 4;
    const double found = after(samples, field, radii, [&](int sample) { return std::cos(angle * sample); })[0];
    const std::complex<double> turn = std::polar(1.0, angle * samples);
    largest = std::max(largest, std::abs(found - (harmonic(field, {0.0, 1.0}) * turn).real()));
  }
  return largest;
}

ON_RANKS(1);

TEST(SurfacePressure, IsExactForAParabola) {
  // s -> (a/c) d/dt in the pressure of a harmonic P: s - s^2 and s/2 + 0 s^2 of P = i^2, when it has lasted.
  constexpr int samples = 2000;
  const auto square = [](int sample) { return static_cast<double>(sample) * sample; };
  for (const double radius : {2e-4, 0.01, 0.3}) {
    const double scale = radius / metres_per_sample;
    const double slope = 2.0 * samples * scale;
    const double bend = 2.0 * scale * scale;
    EXPECT_NEAR(after(samples, Field::pulsating, {radius}, square)[0], slope - bend, 1e-12 * square(samples));
    EXPECT_NEAR(after(samples, Field::oscillating, {radius}, square)[0], slope / 2, 1e-12 * square(samples));
  }
}

TEST(SurfacePressure, IsOfThirdOrderForAHarmonicMotion) {
  for (const Field field : {Field::pulsating, Field::oscillating}) {
    const double coarse = harmonic_error(field, 40);
    EXPECT_LT(coarse, 2e-4);
    EXPECT_NEAR(coarse / harmonic_error(field, 80), 8.0, 1.0);
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
