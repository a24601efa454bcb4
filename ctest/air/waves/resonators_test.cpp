// The air in a tube and in a Helmholtz resonator. Both are solids of revolution whose inner bottom moves in one pulse.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "long_verification.hpp"
#include "ranks.hpp"
#include "ringing.hpp"
#include "tube.hpp"

namespace idiophone::waves {
namespace {

using std::numbers::pi;
constexpr double wall = 0.005;  // m

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
  if (GetParam() < 0.005) {
    LONG_VERIFICATION();
  }
  constexpr double radius = 0.015, length = 0.15;
  const auto tube = closed_tube(radius, length, wall);
  const Recording heard = record(tube, wall, GetParam(), Vector3(0.0, 0.0, wall + 0.02), 0.02);
  const double percent = GetParam() < 0.005 ? 0.3 : 0.6;
  for (const double converged : {534.590, 1605.666}) {  // Hz, tools/tube_resonances
    expect_within(percent, frequency_near(heard, converged, 0.014), converged);
  }
}

TEST_P(Resonators, HelmholtzResonator) {
  if (GetParam() < 0.005) {
    LONG_VERIFICATION();
  }
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
  const Recording heard = record(resonator, wall, GetParam(), Vector3(0.0, 0.0, wall + 0.03), 0.026);
  expect_within(0.6, frequency_near(heard, expected, 0.02), expected);
}

}  // namespace
}  // namespace idiophone::waves
