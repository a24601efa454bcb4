// The air in a tube and in a Helmholtz resonator. Both are solids of revolution whose inner bottom moves in one pulse.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "idiophone/air/waves/pulse_response.hpp"
#include "ranks.hpp"
#include "ringing.hpp"

namespace idiophone::waves {
namespace {

using std::numbers::pi;
constexpr double wall = 0.005;  // m

/// A closed profile in the plane of the axis: distance from the axis and height, m, with the solid on its left.
using Profile = std::vector<std::array<double, 2>>;

/// The solid that a profile sweeps about the z axis.
radiation::Solid revolved(const Profile& profile) {
  constexpr int around = 60;
  const auto points = static_cast<Index>(profile.size());
  radiation::Solid solid;
  for (int step = 0; step < around; ++step) {
    const double angle = 2.0 * pi * step / around;
    for (const auto& [radius, height] : profile) {
      solid.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (Index step = 0; step < around; ++step) {
    const Index here = step * points, next = (step + 1) % around * points;
    for (Index p = 0; p < points; ++p) {
      const Index q = (p + 1) % points;
      if (profile[q][0] > 0.0) {
        solid.triangles.push_back({here + p, next + q, here + q});
      }
      if (profile[p][0] > 0.0) {
        solid.triangles.push_back({here + p, next + p, next + q});
      }
    }
  }
  return solid;
}

/// Pressure at a point of the air, step by step.
struct Recording {
  std::vector<double> pressure;
  double step = 0.0;  // s
};

Recording record(const radiation::Solid& solid, double cell, const Vector3& place, double duration) {
  const auto positions = positions_of(solid);
  const auto shape = shape_of(solid, [](const Vector3& at, const Vector3& normal) {
    return normal[2] > 0.5 && std::abs(at[2] - wall) < 1e-9 ? 1.0 : 0.0;
  });
  PulsedField pulsed({.obstruction = {solid.triangles, positions},
                      .shape = shape,
                      .cell = cell,
                      .speed = speed,
                      .impedance = impedance});
  const Vector3 cells = pulsed.plan().grid.in_cells(place);
  const Index number =
      pulsed.field().slab().number(static_cast<int>(cells[0]), static_cast<int>(cells[1]), static_cast<int>(cells[2]));
  Recording recording;
  while (pulsed.time() < duration) {
    pulsed.advance();
    recording.pressure.push_back(pulsed.field().pressure(number));
  }
  recording.step = pulsed.time() / static_cast<double>(recording.pressure.size());
  return recording;
}

/// Spectrum of a part of a recording in Hann's window.
Complex spectrum(const Recording& recording, double start, double length, double frequency) {
  Complex sum = 0.0;
  const auto first = static_cast<std::size_t>(start / recording.step);
  const auto count = static_cast<std::size_t>(length / recording.step);
  for (std::size_t i = 0; i < count; ++i) {
    const double time = static_cast<double>(first + i) * recording.step;
    const double window = 1.0 - std::cos(2.0 * pi * static_cast<double>(i) / static_cast<double>(count));
    sum += window * recording.pressure.at(first + i) * std::exp(Complex(0.0, -2.0 * pi * frequency * time));
  }
  return sum;
}

/// The frequency near another one, by its phase in two parts of the recording: decay does not change it.
double frequency_near(const Recording& recording, double expected, double length) {
  constexpr double start = 0.003, later = 0.002;  // s
  const Complex turn =
      spectrum(recording, start + later, length, expected) / spectrum(recording, start, length, expected);
  return expected + std::arg(turn) / (2.0 * pi * later);
}

/// Length that the open end of a pipe adds, of outer radius `outer` (Dalmont, Nederveen and Joly 2001, eq. 32), and its
/// change with frequency (Silva et al. 2009).
double end_correction(double radius, double outer, double frequency) {
  const double ratio = radius / outer, square = std::pow(2.0 * pi * frequency / speed * radius, 2);
  const double still = 0.8216 + ratio * (0.6133 - 0.8216) + 0.057 * ratio * (1.0 - std::pow(ratio, 5));
  return radius * still * (1.0 + 0.0599 * square) / (1.0 + 0.238 * square);
}

class Resonators : public testing::TestWithParam<double> {
 protected:
  static void expect_within(double percent, double heard, double expected) {
    const double error = 100.0 * (heard / expected - 1.0);
    RecordProperty("percent at " + std::to_string(expected), std::to_string(error));
    EXPECT_NEAR(error, 0.0, percent);
  }
};
INSTANTIATE_TEST_SUITE_P(, Resonators, testing::Values(0.006, 0.003));

ON_RANKS(1);

TEST_P(Resonators, TubeClosedAtOneEnd) {
  constexpr double radius = 0.015, length = 0.15;
  const auto tube = revolved({{0.0, 0.0},
                              {radius + wall, 0.0},
                              {radius + wall, wall + length},
                              {radius, wall + length},
                              {radius, wall},
                              {0.0, wall}});
  const Recording heard = record(tube, GetParam(), Vector3(0.0, 0.0, wall + 0.02), 0.02);
  for (const int quarters : {1, 3}) {
    double expected = quarters * speed / (4.0 * length);
    for (int i = 0; i < 20; ++i) {  // k (length + end) = a number of quarter turns
      expected = quarters * speed / (4.0 * (length + end_correction(radius, radius + wall, expected)));
    }
    const double percent = GetParam() < 0.005 ? 0.45 : 0.9;
    expect_within(percent, frequency_near(heard, expected, 0.014), expected);
  }
}

TEST_P(Resonators, HelmholtzResonator) {
  constexpr double radius = 0.012, neck = 0.03, cavity_radius = 0.04, cavity = 0.06;
  constexpr double outer = cavity_radius + wall, top = wall + cavity;
  const auto resonator = revolved({{0.0, 0.0},
                                   {outer, 0.0},
                                   {outer, top + neck},
                                   {radius, top + neck},
                                   {radius, top},
                                   {cavity_radius, top},
                                   {cavity_radius, wall},
                                   {0.0, wall}});
  constexpr double ratio = radius / cavity_radius;
  const double inner_end = 0.82 * radius * (1.0 - 1.35 * ratio + 0.31 * std::pow(ratio, 3));  // Kergomard, Garcia 1987
  double expected = 300.0;
  for (int i = 0; i < 50; ++i) {  // tan(k neck) tan(k cavity) = area of the neck/area of the cavity
    const double effective = neck + inner_end + end_correction(radius, outer, expected);
    const double k = 2.0 * pi * expected / speed;
    expected *= std::sqrt(ratio * ratio / (std::tan(k * effective) * std::tan(k * cavity)));
  }
  const Recording heard = record(resonator, GetParam(), Vector3(0.0, 0.0, wall + 0.03), 0.026);
  expect_within(0.6, frequency_near(heard, expected, 0.02), expected);
}

}  // namespace
}  // namespace idiophone::waves
